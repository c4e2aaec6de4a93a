#!/usr/bin/env bash
# How many files `psdl check` reads in a second, and how much memory it takes: benches/files.sh [COUNT]
# Copies of the programs of $PSDL_CORPUS (else of the examples) in a temporary folder; needs GNU time.
set -euo pipefail
cd "$(dirname "$0")/.."
count=${1:-10000}
cargo build --release --quiet
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
programs=("${PSDL_CORPUS:-examples}"/*.psdl)
for ((i = 0; i < count; i++)); do
  [ $((i % 1000)) = 0 ] && mkdir -p "$folder/$((i / 1000))"
  cp "${programs[i % ${#programs[@]}]}" "$folder/$((i / 1000))/$i.psdl"
done
for format in json text; do
  /usr/bin/time -f "$format: $count files in %e s, %M KB at most" "${CARGO_TARGET_DIR:-target}/release/psdl" check --exit-zero --format "$format" "$folder" >/dev/null
done
