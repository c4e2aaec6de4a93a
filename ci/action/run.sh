#!/usr/bin/env bash
# What the action does. Takes its inputs from the environment (PSDL_…), writes annotations to standard output, the summary to
# GITHUB_STEP_SUMMARY, and says what came of it in GITHUB_OUTPUT: findings, status, sarif, patch, pictures.
# Paths and messages come from the repository, which may be anyone's: none of them is ever run, nor read as an option.
set -uo pipefail

psdl=${PSDL:?the program}
out=${PSDL_OUT:?a folder to write to}
output=${GITHUB_OUTPUT:-/dev/null}
summary=${GITHUB_STEP_SUMMARY:-/dev/null}
mkdir -p "$out"

mapfile -t paths < <(grep -v '^[[:space:]]*$' <<<"${PSDL_PATHS:-.}")
set_output() { printf '%s=%s\n' "$1" "$2" >> "$output"; }

# A text from the repository inside of Markdown: nothing of it is markup.
plain() { sed -e 's/[][\\`*_{}<>#|~!&]/\\&/g' <<<"$1"; }

# A path inside of a URL.
encoded() { python3 -c 'import sys, urllib.parse; print(urllib.parse.quote(sys.argv[1]))' "$1"; }

annotate() {
  # GitHub shows the first annotations of a step only, so that the worst stand first in psdl's own order.
  "$psdl" check --format github -- "${paths[@]}"
  status=$?
  "$psdl" check --format json --exit-zero -- "${paths[@]}" > "$out/report.json" 2>/dev/null || true
  findings=$(python3 -c 'import json, sys; s = json.load(open(sys.argv[1]))["summary"]; print(s["errors"] + s["warnings"])' "$out/report.json" 2>/dev/null || echo 0)
  set_output findings "$findings"
}

sarif() {
  [ -n "${PSDL_SARIF:-}" ] || return 0
  "$psdl" check --format sarif --exit-zero -- "${paths[@]}" > "$PSDL_SARIF" && set_output sarif "$PSDL_SARIF"
}

fix() {
  [ "${PSDL_FIX:-false}" = true ] || return 0
  "$psdl" fix --diff --color never -- "${paths[@]}" > "$out/psdl-fix.txt" 2>/dev/null
  # Only the diff: what is said about it is for people.
  python3 - "$out/psdl-fix.txt" "$out/psdl-fix.patch" <<'PYTHON'
import re, sys
kept, left = [], [0, 0]
for line in open(sys.argv[1], encoding="utf-8", newline=""):
    hunk = re.match(r"@@ -\d+(?:,(\d+))? \+\d+(?:,(\d+))? @@", line)
    if hunk:
        left = [int(count or 1) for count in hunk.groups()]
        kept.append(line)
    elif any(left):
        kept.append(line)
        left[0] -= line[0] in " -"
        left[1] -= line[0] in " +"
    elif line.startswith(("--- ", "+++ ", "\\ No newline")):
        kept.append(line)
open(sys.argv[2], "w", encoding="utf-8", newline="").write("".join(kept))
PYTHON
  if [ -s "$out/psdl-fix.patch" ]; then
    set_output patch "$out/psdl-fix.patch"
  else
    rm -f "$out/psdl-fix.patch"
  fi
}

# The programs that differ from the base, or whose template does; all of the paths where nothing is known of the base.
changed() {
  local base=${PSDL_BASE:-} names=(-z --name-only --diff-filter=ACMR)
  [[ $base =~ ^0*$ ]] && base=
  if [ -n "$base" ] && git rev-parse --quiet --verify "$base^{commit}" >/dev/null; then
    git diff "${names[@]}" "$base" -- "${paths[@]}"
  else
    git ls-files -z -- "${paths[@]}"
  fi | while IFS= read -r -d '' file; do
    case $file in
      *.psdl) printf '%s\0' "$file" ;;
      *.template.json) [ -f "${file%.template.json}.psdl" ] && printf '%s\0' "${file%.template.json}.psdl" ;;
    esac
  done | sort -zu
}

pictures() {
  local file
  scenes=() drawn=()
  [ "${PSDL_SUMMARY:-true}" = true ] || [ "${PSDL_PICTURES:-artifact}" != none ] || return 0
  mapfile -d '' -t scenes < <(changed)
  [ "${PSDL_PICTURES:-artifact}" != none ] || return 0
  for file in "${scenes[@]}"; do
    mkdir -p "$out/pictures/$(dirname -- "$file")"
    # A program with errors is drawn too, as far as it comes; one that cannot be drawn is only named.
    "$psdl" render --errors --size 1200x700 --output "$out/pictures/${file%.psdl}.png" -- "$file" >/dev/null 2>&1
    [ -s "$out/pictures/${file%.psdl}.png" ] && drawn+=("$file")
  done
  [ ${#drawn[@]} -eq 0 ] || set_output pictures "$out/pictures"
}

# Puts the pictures where a summary can show them: on a branch that holds nothing else. Says the address of their folder.
publish() {
  local branch=psdl-pictures where tree commit index
  where="${GITHUB_SHA:?}-${GITHUB_RUN_ID:-0}"
  index=$(mktemp -u)
  export GIT_INDEX_FILE=$index GIT_AUTHOR_NAME=psdl GIT_AUTHOR_EMAIL=psdl@users.noreply.github.com
  export GIT_COMMITTER_NAME=$GIT_AUTHOR_NAME GIT_COMMITTER_EMAIL=$GIT_AUTHOR_EMAIL
  local attempt parent
  for attempt in 1 2 3; do
    parent=
    rm -f "$index"
    if git fetch --quiet --depth 1 origin "refs/heads/$branch" 2>/dev/null; then
      parent=$(git rev-parse FETCH_HEAD)
      git read-tree "$parent"
    fi
    (cd "$out/pictures" && find . -type f -name '*.png' -print0) | while IFS= read -r -d '' file; do
      git update-index --add --cacheinfo "100644,$(git hash-object -w -- "$out/pictures/$file"),$where/${file#./}"
    done
    tree=$(git write-tree)
    commit=$(git commit-tree "$tree" ${parent:+-p "$parent"} -m "Pictures of scenes at $GITHUB_SHA")
    # Another job may have been faster: then once more, on top of it.
    if git push --quiet origin "$commit:refs/heads/$branch" 2>/dev/null; then
      rm -f "$index"
      echo "${GITHUB_SERVER_URL:-https://github.com}/${GITHUB_REPOSITORY:?}/blob/$branch/$where"
      return 0
    fi
  done
  rm -f "$index"
  return 1
}

summarise() {
  [ "${PSDL_SUMMARY:-true}" = true ] || return 0
  local file address= counts
  if [ "${PSDL_PICTURES:-artifact}" = branch ] && [ ${#drawn[@]} -gt 0 ]; then
    address=$(publish) || echo "::notice title=psdl::The pictures could not be pushed to the branch psdl-pictures (contents: write is needed); they are an artifact."
  fi
  {
    echo "## Scenes"
    echo
    python3 - "$out/report.json" <<'PYTHON'
import json, sys
summary = json.load(open(sys.argv[1]))["summary"]
kinds = ", ".join(f"{count} {kind}" for kind, count in summary.get("kinds", {}).items())
def many(number, word):
    return f"{number} {word}{'' if number == 1 else 's'}"
print(f"{many(summary['errors'], 'error')}, {many(summary['warnings'], 'warning')} in {many(summary['files'], 'program')}{': ' + kinds if kinds else ''}.")
PYTHON
    [ ! -e "$out/psdl-fix.patch" ] || printf '\nCorrections are in the artifact `psdl-fix`: `git apply -p0 psdl-fix.patch`.\n'
    if [ ${#scenes[@]} -gt 0 ]; then
      printf '\n### Changed\n'
      for file in "${scenes[@]}"; do
        printf '\n**%s**' "$(plain "$file")"
        counts=$(python3 - "$out/report.json" "$file" <<'PYTHON'
import json, os, sys
report, name = json.load(open(sys.argv[1])), os.path.normpath(sys.argv[2])
own = [entry for entry in report["files"] if os.path.normpath(entry["path"]) == name]
errors = sum(finding["severity"] == "error" for entry in own for finding in entry["findings"])
print("no errors" if errors == 0 else f"{errors} error{'' if errors == 1 else 's'}")
PYTHON
        )
        printf ': %s\n' "$counts"
        if [ -n "$address" ] && [ -s "$out/pictures/${file%.psdl}.png" ]; then
          printf '\n![%s](%s/%s?raw=true)\n' "$(plain "$file")" "$address" "$(encoded "${file%.psdl}.png")"
        fi
      done
      if [ -z "$address" ] && [ ${#drawn[@]} -gt 0 ]; then
        printf '\nTheir pictures are in the artifact `psdl-pictures`.\n'
      fi
    fi
  } >> "$summary"
}

scenes=() drawn=()
annotate
sarif
fix
pictures
summarise
if [ "$status" -eq 1 ] && [ "${PSDL_FAIL:-true}" != true ]; then status=0; fi
set_output status "$status"
exit 0
