#!/usr/bin/env bash
# The program for the action.   install.sh find: that of PSDL_PROGRAM or of PATH, if there is one; install.sh build: from this source.
# Says where it is as the output `program`.
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

say() { echo "program=$1" | tee -a "${GITHUB_OUTPUT:-/dev/null}"; }

case ${1:?find or build} in
  find)
    if [ -n "${PSDL_PROGRAM:-}" ]; then
      "$PSDL_PROGRAM" --version >/dev/null || { echo "::error title=psdl::$PSDL_PROGRAM cannot be run" && exit 2; }
      say "$PSDL_PROGRAM"
    else
      say "$(command -v psdl || true)"
    fi
    ;;
  build)
    root=${XDG_CACHE_HOME:-$HOME/.cache}/psdl-action
    if [ ! -x "$root/bin/psdl" ]; then
      rust=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' "$source/Cargo.toml")
      rustup toolchain install --profile minimal "$rust" >&2
      cargo "+$rust" install --locked --path "$source" --root "$root" >&2
    fi
    say "$root/bin/psdl"
    ;;
esac
