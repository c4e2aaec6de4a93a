import math

points = [(math.cos(i * 0.01) * i, math.sin(i * 0.01) * i) for i in range(20000)]
length = 0.0
for (x0, y0), (x1, y1) in zip(points, points[1:]):
    length += math.hypot(x1 - x0, y1 - y0)
boxes = [(x, y, x + 1.0, y + 1.0) for x, y in points[:300]]
hits = 0
for i, a in enumerate(boxes):
    for b in boxes[:i]:
        if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]:
            hits += 1
print(round(length, 6), hits)
