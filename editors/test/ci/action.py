"""Runs the steps of action.yml as GitHub's runner does: conditions, inputs, outputs of earlier steps, the environment of each.

    action.py ACTION.YML FOLDER [INPUT=VALUE…]

FOLDER takes the runner's files. Prints what the steps print, then `artifact NAME PATH` for each that would be uploaded, then the outputs of the action
as `output NAME=VALUE`; ends as the job would. `uses:` steps are not run: of an upload only the path is looked at.
"""

import os
import pathlib
import re
import subprocess
import sys

import yaml

TOKEN = re.compile(r"'[^']*'|\|\||&&|[!=]=|[A-Za-z_][\w.-]*|\S")


def lookup(path, contexts):
    """The value of `steps.run.outputs.patch`; what is not there is empty."""
    value = contexts
    for part in path.split("."):
        value = value.get(part, "") if isinstance(value, dict) else ""
    return value


def evaluate(expression, contexts):
    """An expression of names, strings, `||`, `&&`, `==` and `!=`: all that this action uses."""
    words = {"||": "or", "&&": "and"}
    python = []
    for token in TOKEN.findall(expression):
        if token in words:
            python.append(words[token])
        elif re.match(r"[A-Za-z_]", token):
            python.append(repr(lookup(token, contexts)))
        elif token[0] == "'" or token in ("==", "!="):
            python.append(token)
        else:
            sys.exit(f"not understood: {token} in {expression}")
    return eval(" ".join(python), {"__builtins__": {}})


def expand(text, contexts):
    return re.sub(r"\$\{\{(.*?)\}\}", lambda found: str(evaluate(found[1].strip(), contexts)), str(text))


def main():
    file, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    action = yaml.safe_load(file.read_text())
    inputs = {name: known.get("default", "") for name, known in action["inputs"].items()}
    for given in sys.argv[3:]:
        name, value = given.split("=", 1)
        if name not in inputs:
            sys.exit(f"no such input: {name}")
        inputs[name] = value
    folder.mkdir(parents=True, exist_ok=True)
    contexts = {"inputs": inputs, "steps": {}, "runner": {"temp": str(folder)}, "github": {"action_path": str(file.parent), "event": {}}}
    status = 0
    for number, step in enumerate(action["runs"]["steps"]):
        if status or not evaluate(step.get("if", "'always'"), contexts):
            continue
        if "uses" in step:
            if step["uses"].startswith("actions/upload-artifact@"):
                given = {name: expand(value, contexts) for name, value in step["with"].items()}
                if not os.path.exists(given["path"]):
                    sys.exit(f"nothing to upload: {given}")
                print(f"artifact {given['name']} {given['path']}")
            continue
        output = folder / f"output-{number}"
        output.write_text("")
        environment = {name: expand(value, contexts) for name, value in step.get("env", {}).items()}
        own = {"GITHUB_ACTION_PATH": str(file.parent), "GITHUB_OUTPUT": str(output), "GITHUB_STEP_SUMMARY": str(folder / "summary.md")}
        shell = {"bash": ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c"]}[step["shell"]]
        sys.stdout.flush()
        status = subprocess.run([*shell, expand(step["run"], contexts)], env={**os.environ, **own, **environment}).returncode
        said = dict(line.split("=", 1) for line in output.read_text().splitlines())
        if "id" in step:
            contexts["steps"][step["id"]] = {"outputs": said}
    for name, known in action["outputs"].items():
        print(f"output {name}={expand(known['value'], contexts)}")
    sys.exit(status)


main()
