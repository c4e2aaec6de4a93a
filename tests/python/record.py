"""Re-records what CPython 3.11 prints for every snippet of this folder.

    python3.11 tests/python/record.py [NAME ...]

Each `NAME.py` is run on its own; what it prints goes to `NAME.out`. A snippet that ends with an exception
adds one line, `Type: message` (or `Type` where the message is empty), which is the last line of CPython's
traceback without its hints ("Did you mean ...") and notes. Only a snippet whose name begins with `exc_` may end so.

Every snippet is run under several hash seeds: one whose output depends on the order of a set of strings,
on an address or on a clock is refused.
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent

DRIVER = """
import sys, types
path = sys.argv[1]
module = types.ModuleType('__main__')
sys.modules['__main__'] = module
code = compile(open(path, encoding='utf-8').read(), path, 'exec')
try:
    exec(code, module.__dict__)
except BaseException as error:
    kind = type(error)
    name = kind.__qualname__
    if kind.__module__ not in ('__main__', 'builtins'):
        name = kind.__module__ + '.' + name
    text = str(error)
    print(name + ': ' + text if text else name)
    sys.exit(3)
"""


def run(path, seed):
    done = subprocess.run(
        [sys.executable, "-s", "-B", "-W", "ignore", "-X", "utf8", "-c", DRIVER, str(path)],
        capture_output=True,
        env={"PYTHONHASHSEED": str(seed), "PATH": "/usr/bin:/bin"},
        timeout=60,
    )
    if done.stderr or done.returncode != (3 if path.name.startswith("exc_") else 0):
        sys.exit(f"{path.name}: {done.stdout[-300:].decode()}{done.stderr.decode()}")
    return done.stdout


def main(names):
    if sys.version_info[:2] != (3, 11):
        sys.exit(f"CPython 3.11 records these, not {sys.version.split()[0]}")
    snippets = [HERE / f"{name}.py" for name in names] or sorted(HERE.glob("*.py"))
    for path in snippets:
        if path.name == "record.py":
            continue
        text = run(path, 0)
        if any(run(path, seed) != text for seed in (1, 2)):
            sys.exit(f"{path.name}: the output differs from run to run")
        path.with_suffix(".out").write_bytes(text)
    known = {p.stem for p in HERE.glob("*.py")}
    for out in HERE.glob("*.out"):
        if out.stem not in known:
            sys.exit(f"{out.name} belongs to no snippet")


if __name__ == "__main__":
    main(sys.argv[1:])
