"""Runs programs in the reference implementation (oracle.py, in the folder that the first argument names).

One program a line of stdin, as a JSON string. One line of stdout for each: its layout or the last line of its traceback, and what it printed.
"""
import io
import json
import sys

sys.path.insert(0, sys.argv[1])
import oracle

for line in sys.stdin:
    printed, sys.stderr = sys.stderr, io.StringIO()
    try:
        layout = oracle.run(json.loads(line))
    except Exception as error:
        layout = {"raised": f"{type(error).__name__}: {error}"}
    printed, sys.stderr = sys.stderr, printed
    layout["printed"] = printed.getvalue()
    print(json.dumps(layout))
