class Box:
    def __init__(self, x, w):
        self.x = x
        self.w = w

    @property
    def right(self):
        return self.x + self.w

    def overlaps(self, other):
        return self.x < other.right and other.x < self.right


boxes = [Box(i * 0.7 % 50, 0.5) for i in range(350)]
count = 0
for a in boxes:
    for b in boxes:
        if a is not b and a.overlaps(b):
            count += 1
print(count)
