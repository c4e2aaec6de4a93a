"""Exports scenes with psdl, and reads every file with the programs that it is written for.

    read_back.py PSDL ROOT OUT       PSDL: the program, ROOT: the checkout, OUT: a folder for the files

The scenes are the examples, those in `scenes/` and the programs in the folders of PSDL_CORPUS. What a reader finds is compared with
the layout that psdl reports: objects, names, boxes. Ends with "foreign: N passed, N failed".
"""
import csv
import html.parser
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys

PSDL, ROOT, OUT = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
HERE = pathlib.Path(__file__).parent
FORMATS = ["layout", "glb", "usda", "obj", "csv", "visualizer", "html", "mjcf", "urdf"]
FACINGS = {"X+": "EAST", "Y+": "NORTH", "X-": "WEST", "Y-": "SOUTH"}

passed = failed = 0


def check(name, good, what=""):
    global passed, failed
    if good:
        passed += 1
    else:
        failed += 1
        print(f"FAILED {name}: {what}")


def run(*args):
    return subprocess.run([PSDL, *map(str, args)], capture_output=True, text=True)


def near(a, b, tolerance=1e-5):
    return all(abs(x - y) <= tolerance * max(1.0, abs(x), abs(y)) for x, y in zip(a, b, strict=True))


def strict_json(text):
    def refuse(constant):
        raise ValueError(f"{constant} is no JSON")

    return json.loads(text, parse_constant=refuse)


def is_drawn(o):
    values = o["min"] + o["max"]
    if o.get("skip") or any(v is None or abs(v) > 1e9 for v in values):
        return False
    return all(o["max"][k] - o["min"][k] >= 1e-6 for k in range(3))


def y_up(p):
    return [p[0], p[2], -p[1]]


def box_y_up(o):
    low, high = y_up(o["min"]), y_up(o["max"])
    return [min(low[k], high[k]) for k in range(3)], [max(low[k], high[k]) for k in range(3)]


def glb_json(path):
    data = path.read_bytes()
    magic, version, length, size = struct.unpack("<4sIII", data[:16])
    assert (magic, version, length) == (b"glTF", 2, len(data))
    return strict_json(data[20 : 20 + size])


def rotated(q, v):
    x, y, z, w = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]


def read_glb(path, layout, drawn):
    root = glb_json(path)
    nodes = [n for n in root["nodes"] if "path" in n.get("extras", {})]
    assert len(nodes) == len(drawn), f"{len(nodes)} nodes, {len(drawn)} objects"
    for node, o in zip(nodes, drawn):
        about = node["extras"]
        assert (node["name"], about["path"], about["category"], about["support"]) == (o["path"], o["path"], o["name"], o["support"])
        assert isinstance(about["line"], int) and about["lines"] == o["lines"]
        half = [abs(v) / 2 for v in rotated(node.get("rotation", [0, 0, 0, 1]), node["scale"])]
        low, high = box_y_up(o)
        assert near([t - h for t, h in zip(node["translation"], half)], low), o["path"]
        assert near([t + h for t, h in zip(node["translation"], half)], high), o["path"]
        material = root["materials"][root["meshes"][node["mesh"]]["primitives"][0]["material"]]
        assert o["color"] is None or material["name"] == o["color"].upper()


def read_usda(path, layout, drawn):
    from pxr import Gf, Usd, UsdGeom

    stage = Usd.Stage.Open(str(path))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert stage.GetDefaultPrim().GetPath() == "/Scene"
    cubes = [p for p in stage.Traverse() if p.IsA(UsdGeom.Cube)]
    assert len(cubes) == len(drawn), f"{len(cubes)} cubes"
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"])
    for prim, o in zip(cubes, drawn):
        about = prim.GetCustomData()
        assert about["path"] == o["path"].replace("\0", "\ufffd") and about["category"] == o["name"].replace("\0", "\ufffd"), o["path"]
        assert prim.GetDisplayName() == about["path"] and about["support"] == o["support"]
        box = cache.ComputeWorldBound(prim).ComputeAlignedRange()
        assert near(box.GetMin(), o["min"]) and near(box.GetMax(), o["max"]), o["path"]


def read_obj(path, layout, drawn):
    import trimesh

    assert path.read_text().count("\no ") >= len(drawn)
    if not drawn:
        return
    loaded = trimesh.load(path, force="scene", split_objects=True, group_material=False)
    groups = {}
    for line in path.read_text().split("\n"):
        word, _, rest = line.partition(" ")
        if word == "o":
            corners = groups.setdefault(rest, [])
        elif word == "v":
            corners.append([float(v) for v in rest.split()])
    boxes = list(groups.values())
    for corners, o in zip(boxes, drawn):
        low, high = box_y_up(o)
        assert near([min(c[k] for c in corners) for k in range(3)], low) and near([max(c[k] for c in corners) for k in range(3)], high), o["path"]
    everything = [c for corners in boxes for c in corners]
    bounds = loaded.bounds
    assert near(bounds[0], [min(c[k] for c in everything) for k in range(3)]) and near(bounds[1], [max(c[k] for c in everything) for k in range(3)])


def read_csv(path, layout, drawn):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(layout["objects"])
    for row, o in zip(rows, layout["objects"]):
        guarded = "'" if o["name"][:1] in "=+-@\t\r\n" and o["name"] else ""
        assert row["category"] == guarded + o["name"] and row["path"] == o["path"] and row["support"] == o["support"]
        for k, axis in enumerate("xyz"):
            for part in ("center", "min", "max"):
                value = o[part][k]
                found = float(row[f"{part}_{axis}"])
                assert found == value if value is not None else not math.isfinite(found), o["path"]
        assert row["placed"] == ("false" if o.get("skip") else "true")


def read_visualizer(path, layout, drawn):
    root = strict_json(path.read_text())
    assert list(root) == ["name", "size", "objects", "relations", "number_of_constants", "fill_percentage"]
    assert root["name"] == layout["scene"]["title"]
    assert root["size"] == [layout["scene"][k] for k in ("width", "height", "depth")]
    things = [o for o in layout["objects"] if not o.get("skip") and None not in o["min"] + o["max"] + o["center"]]
    types = [o["type"] for o in root["objects"]]
    rest = types[len(things) :]
    assert rest == ["FLOOR"] + ["WALL"] * (4 if layout["scene"]["interior"] else 0), rest
    for found, o in zip(root["objects"], things):
        turned = o["facing"][0] == "X"
        size = [o["depth"] if turned else o["width"], o["height"], o["width"] if turned else o["depth"]]
        assert (found["name"], found["type"], found["facing"]) == (o["name"], o["type"], FACINGS[o["facing"]])
        assert found["position"] == y_up(o["center"]) and found["size"] == size
    for relation in root["relations"]:
        assert list(relation) == ["name", "arity", "args", "loss"]
        assert len(relation["arity"]) == len(relation["args"]) and all(0 <= a < len(things) for a in relation["args"])
    assert isinstance(root["number_of_constants"], int)


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open, self.data, self.title, self.scripts, self.policy, self.links = [], "", "", 0, "", []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.open.append((tag, attributes.get("id")))
        self.scripts += tag == "script"
        if attributes.get("http-equiv") == "Content-Security-Policy":
            self.policy = attributes["content"]
        self.links += [v for k, v in attributes.items() if k in ("src", "href")]
        assert not any(k.startswith("on") for k in attributes)

    def handle_endtag(self, tag):
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data):
        if self.open and self.open[-1] == ("script", "data"):
            self.data += data
        elif self.open and self.open[-1][0] == "title":
            self.title += data


def read_html(path, layout, drawn):
    page = Page()
    page.feed(path.read_text())
    assert page.scripts == 2 and page.links == ["data:,"], (page.scripts, page.links)
    assert page.policy.startswith("default-src 'none'; script-src 'sha256-") and "unsafe" not in page.policy
    data = strict_json(page.data)
    assert data["title"] == layout["scene"]["title"]
    assert [(o["name"], o["path"]) for o in data["objects"]] == [(o["name"], o["path"]) for o in drawn]
    for found, o in zip(data["objects"], drawn):
        assert near(found["center"], o["center"])
    # Weighted errors that are told to people stand for at least one error each.
    kinds = {v["kind"] for v in layout["violations"]}
    assert kinds <= {f["code"] for f in data["findings"]}


def read_mjcf(path, layout, drawn):
    import mujoco
    import numpy

    model = mujoco.MjModel.from_xml_path(str(path))
    state = mujoco.MjData(model)
    mujoco.mj_forward(model, state)
    assert model.nv == 0 and model.nbody == 1 and state.ncon == 0
    first = model.ngeom - len(drawn)
    for i, o in enumerate(drawn):
        half = numpy.abs(state.geom_xmat[first + i].reshape(3, 3)) @ model.geom_size[first + i]
        center = state.geom_xpos[first + i]
        assert near(center - half, o["min"]) and near(center + half, o["max"]), o["path"]


def read_urdf(path, layout, drawn):
    import numpy
    import yourdfpy

    robot = yourdfpy.URDF.load(str(path), build_scene_graph=False, load_meshes=False)
    links = {link.name: link for link in robot.robot.links}
    joints = [j for j in robot.robot.joints]
    assert all(j.type == "fixed" and j.parent == "scene" for j in joints) and len(links) == len(joints) + 1
    for joint, o in zip(joints[len(joints) - len(drawn) :], drawn):
        box = links[joint.child].collisions[0].geometry.box
        half = numpy.abs(joint.origin[:3, :3]) @ (numpy.array(box.size) / 2)
        center = joint.origin[:3, 3]
        assert near(center - half, o["min"]) and near(center + half, o["max"]), o["path"]


READERS = {"glb": read_glb, "usda": read_usda, "obj": read_obj, "csv": read_csv, "visualizer": read_visualizer}
READERS |= {"html": read_html, "mjcf": read_mjcf, "urdf": read_urdf}


def scenes():
    more = [pathlib.Path(folder) for folder in os.environ.get("PSDL_CORPUS", "").split(os.pathsep) if folder]
    for folder in (ROOT / "examples", HERE / "scenes", *more):
        for path in sorted(folder.glob("*.psdl")):
            yield path.stem, path


def round_trip(name, fmt):
    """Export, import, export, import, export: the second and third file are the same."""
    first, files = OUT / f"{name}.{fmt}", []
    for turn in (1, 2):
        program, again = OUT / f"{name}.{fmt}.{turn}.psdl", OUT / f"{name}.{fmt}.{turn}"
        done = run("import", first, "-o", program)
        if done.returncode == 0:
            done = run("export", "--no-config", "--to", fmt, program, "-o", again)
        if done.returncode != 0:
            return check(f"{name} {fmt} round trip", False, done.stderr[:500])
        files.append(again.read_bytes())
        first = again
    check(f"{name} {fmt} round trip", files[0] == files[1], "another round gives another file")


def main():
    exported = []
    for name, source in scenes():
        layout = None
        for fmt in FORMATS:
            path = OUT / f"{name}.{fmt}"
            done = run("export", "--no-config", "--to", fmt, source, "-o", path)
            if done.returncode != 0:
                check(f"{name} {fmt}", False, done.stderr[:500])
                continue
            try:
                if fmt == "layout":
                    layout = strict_json(path.read_text())
                    drawn = [o for o in layout["objects"] if is_drawn(o)]
                else:
                    READERS[fmt](path, layout, drawn)
                check(f"{name} {fmt}", True)
            except Exception as error:
                check(f"{name} {fmt}", False, f"{type(error).__name__}: {str(error)[:500]}")
        for fmt in ("layout", "visualizer"):
            if name != "extreme":
                round_trip(name, fmt)
        exported.append(name)
    glbs = [OUT / f"{name}.glb" for name in exported]
    reports = subprocess.run(["node", HERE / "validate.cjs", *glbs], capture_output=True, text=True, check=True).stdout
    for line in reports.splitlines():
        report = json.loads(line)
        good = report["errors"] == report["warnings"] == 0
        check(f"{pathlib.Path(report['path']).name} by the Khronos validator", good, json.dumps(report["messages"])[:500])
    browser = os.environ.get("PSDL_CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser:
        pages = [OUT / f"{name}.html" for name in ("gallery", "hostile", "empty", "extreme", "many")]
        shown = subprocess.run(["node", HERE / "page.cjs", browser, *pages], capture_output=True, text=True)
        for line in shown.stdout.splitlines():
            report = json.loads(line)
            check(f"{report['page']}: {report['what']}", report["good"], report.get("why", ""))
        check("the browser", shown.returncode == 0, shown.stderr[-1000:])
    else:
        print("no Chromium here: the pages were NOT opened")
    print(f"foreign: {passed} passed, {failed} failed")
    return failed > 0


sys.exit(main())
