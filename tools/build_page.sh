#!/usr/bin/env bash
# Build the script and style of the report's interactive part: TARGET/page.js and TARGET/page.css.
# usage: build_page.sh TARGET [program]     program: without what only the tests need
#
# Where that cannot be done (no npm, no network) both files are left empty: reports then show
# pictures only. They are dated so that the next build tries again.
set -euo pipefail

target=${1:?usage: build_page.sh TARGET_FOLDER [program]}
what=${2:-tests}
source=$(cd "$(dirname "$0")/../web" && pwd)
mkdir -p "$target/npm"
target=$(cd "$target" && pwd)
work=$target/npm

# What tells the compiler that they are others.
stamp() {
  echo "// $(cat "$target/page.js" "$target/page.css" | sha256sum | cut -c1-64)" > "$target/page_stamp.h"
}

fail() {
  echo "warning: the interactive part of reports was not built: $1" >&2
  echo "hint: $2; reports show pictures only until then" >&2
  : > "$target/page.js"
  : > "$target/page.css"
  stamp
  touch -d @0 "$target/page.js" "$target/page.css" "$target/page_stamp.h"
  exit 0
}

command -v npm >/dev/null || fail "npm is not installed" "apt-get install nodejs npm, then build again"
rm -rf "$work/src" "$work/dist"
cp -r "$source/src" "$source"/*.json "$source/vite.config.js" "$source/.npmrc" "$work"
options=()
[ "$what" = program ] && options+=(--omit=dev)
lock=$(sha256sum "$work/package-lock.json" | cut -c1-64)-$what
if [ "$(cat "$work/installed" 2>/dev/null || true)" != "$lock" ]; then
  (cd "$work" && npm ci --silent "${options[@]}") </dev/null > "$target/npm.log" 2>&1 ||
    fail "npm ci failed (see $target/npm.log)" "check the network or the npm registry setting, then build again"
  echo "$lock" > "$work/installed"
fi
(cd "$work" && node_modules/.bin/vite build --logLevel warn) </dev/null > "$target/vite.log" 2>&1 ||
  { cat "$target/vite.log" >&2; fail "vite found an error" "see above"; }
# The script stands inside <script> in the page.
if grep -qi '</script' "$work/dist/page.js"; then
  fail "page.js holds the end of a script element" "rewrite that string in web/src"
fi
mv -f "$work/dist/page.js" "$work/dist/page.css" "$target"
stamp
