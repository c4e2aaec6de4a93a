"""Runs scripts of scene calls in the reference implementation (oracle.py, in the folder that the first argument names).

One script a line of stdin, as JSON: a list of calls. One line of stdout for each: what the calls gave or raised, and the layout.
"""
import json
import sys

sys.path.insert(0, sys.argv[1])
import oracle

BAD = {"nan": float("nan"), "inf": float("inf"), "text": "a", "true": True, "none": None}


class Script:
    def __init__(self):
        self.world = oracle.World()
        self.names = self.world.names()

    def target(self, index):
        return self.world.scene if index < 0 else self.world.objects[index]

    def value(self, spec):
        if isinstance(spec, str):
            return BAD[spec]
        if isinstance(spec, list):
            target, anchor, axis, plus = spec
            return getattr(getattr(self.target(target), anchor), axis) + plus
        return spec

    def add(self, kind, name, width, depth, height, support):
        width, depth, height = map(self.value, (width, depth, height))
        self.names[kind](name, width, depth, height, support=self.value(support))

    def size(self, width, depth, height):
        self.names["set_size"](width, depth, height)

    def interior(self, interior):
        self.names["set_wall_asset"]("", interior)

    def write(self, target, anchor, axis, value):
        value = self.value(value)
        setattr(getattr(self.target(target), anchor), axis, value)

    def read(self, target, anchor, axis):
        return getattr(getattr(self.target(target), anchor), axis)

    def facing(self, target):
        return self.target(target).facing

    def frame(self, target):
        self.names["set_coordinate_frame"](self.target(target))

    def face(self, target, how, what):
        if how == "number":
            what = self.value(what)
        elif how == "toward":
            what = self.target(what)
        elif how in ("min", "center", "max"):
            what = getattr(self.target(what), how)
        self.target(target).facing = what


for line in sys.stdin:
    script, results = Script(), []
    for name, *args in json.loads(line):
        try:
            results.append(getattr(script, name)(*args))
        except (TypeError, ValueError, AttributeError, OverflowError) as error:
            results.append(f"{type(error).__name__}: {error}")
    layout = script.world.layout()
    layout["results"] = results
    layout["warnings"] = len(script.world.warnings)
    print(json.dumps(layout))
