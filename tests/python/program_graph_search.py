from collections import deque, defaultdict
import itertools
graph = {"A": {"B": 4, "C": 2}, "B": {"D": 5}, "C": {"B": 1, "D": 8, "E": 10}, "D": {"E": 2, "F": 6}, "E": {"F": 3}, "F": {}}
def dijkstra(g, start):
    dist, prev, todo = {start: 0}, {}, {start}
    done = set()
    while todo:
        u = min(sorted(todo), key=dist.get)
        todo.remove(u)
        done.add(u)
        for v, w in g[u].items():
            if v not in done and dist[u] + w < dist.get(v, float("inf")):
                dist[v], prev[v] = dist[u] + w, u
                todo.add(v)
    return dist, prev
dist, prev = dijkstra(graph, "A")
print(dist)
path, n = [], "F"
while n != "A":
    path.append(n)
    n = prev[n]
print("A", *reversed(path), sep=" -> ")
maze = """
#########
#S..#...#
#.#.#.#.#
#.#...#E#
#########
""".strip().split("\n")
find = lambda ch: next((r, c) for r, row in enumerate(maze) for c, v in enumerate(row) if v == ch)
def bfs(start, goal):
    q, seen = deque([(start, 0)]), {start}
    while q:
        (r, c), d = q.popleft()
        if (r, c) == goal: return d
        for dr, dc in ((0, 1), (1, 0), (0, -1), (-1, 0)):
            p = r + dr, c + dc
            if maze[p[0]][p[1]] != "#" and p not in seen:
                seen.add(p)
                q.append((p, d + 1))
print(find("S"), find("E"), bfs(find("S"), find("E")))
def toposort(deps):
    order, state = [], {}
    def visit(n, trail=()):
        if state.get(n) == 2: return
        if state.get(n) == 1: raise ValueError("cycle: " + " -> ".join(trail + (n,)))
        state[n] = 1
        for d in deps.get(n, ()): visit(d, trail + (n,))
        state[n] = 2
        order.append(n)
    for n in deps: visit(n)
    return order
print(toposort({"app": ["lib", "log"], "lib": ["core"], "log": ["core"], "core": []}))
try:
    toposort({"a": ["b"], "b": ["c"], "c": ["a"]})
except ValueError as e:
    print(e)
class Union:
    def __init__(self): self.p = {}
    def find(self, x):
        self.p.setdefault(x, x)
        while self.p[x] != x:
            self.p[x] = self.p[self.p[x]]
            x = self.p[x]
        return x
    def join(self, a, b):
        a, b = self.find(a), self.find(b)
        self.p[a] = b
        return a != b
edges = [(7, "A", "D"), (5, "A", "B"), (8, "B", "C"), (9, "B", "D"), (7, "B", "E"), (5, "C", "E"), (15, "D", "E"), (6, "D", "F"), (8, "E", "F"), (9, "E", "G"), (11, "F", "G")]
u = Union()
mst = [(w, a, b) for w, a, b in sorted(edges) if u.join(a, b)]
print(mst, sum(w for w, _, _ in mst))
cities = {"a": (0, 0), "b": (3, 4), "c": (6, 0), "d": (3, -4)}
d = lambda p, q: ((cities[p][0] - cities[q][0]) ** 2 + (cities[p][1] - cities[q][1]) ** 2) ** 0.5
best = min(itertools.permutations("bcd"), key=lambda p: sum(d(x, y) for x, y in zip(("a", *p), (*p, "a"))))
print(best, sum(d(x, y) for x, y in zip(("a", *best), (*best, "a"))))
adj = defaultdict(list)
for a, b in [(1, 2), (2, 3), (4, 5), (6, 6)]:
    adj[a].append(b)
    adj[b].append(a)
seen, comps = set(), []
for n in adj:
    if n in seen: continue
    stack, comp = [n], []
    while stack:
        x = stack.pop()
        if x in seen: continue
        seen.add(x)
        comp.append(x)
        stack.extend(adj[x])
    comps.append(sorted(comp))
print(comps)
