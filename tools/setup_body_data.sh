#!/usr/bin/env bash
# Fetch and bake the body data; does nothing when the baked file is there and current.
# usage: setup_body_data.sh BUILD_BIN_DIR
set -euo pipefail

bin=${1:?usage: setup_body_data.sh BUILD_BIN_DIR (the folder that holds loosefit_bake)}
tools=$(cd "$(dirname "$0")" && pwd)
target=$tools/../var/body
mkdir -p "$target"
target=$(cd "$target" && pwd)
[ -x "$bin/loosefit_bake" ] || {
  echo "error: $bin/loosefit_bake is missing" >&2
  echo "hint: run: make build" >&2
  exit 1
}

# The tests read the source files too, so both must be there.
if [ -s "$target/raw/targets.bin" ] && "$bin/loosefit_bake" --check "$target/body.lfb" 2>/dev/null; then
  echo "body data: baked and current"
  exit 0
fi
"$tools/fetch_body_data.sh" "$target/raw"
"$bin/loosefit_bake" "$target/raw" "$target/body.lfb"
