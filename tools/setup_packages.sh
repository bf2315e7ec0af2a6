#!/usr/bin/env bash
# Install the Debian packages Loosefit is built with; does nothing when all are there.
# usage: setup_packages.sh [program | python | slurm]   as root, or as a user who may use sudo
#   program: without what only the tests, the benchmarks and the Python module need
#   python:  the same with what the Python module and its examples need
#   slurm:   with the workload manager that `make test-slurm` brings up
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache make python3 ca-certificates coreutils file dpkg-dev
  libeigen3-dev libsuitesparse-dev libopenblas-dev libtbb-dev libcgal-dev libgmp-dev libmpfr-dev
  libvtk9-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev zlib1g-dev libexpat1-dev
  libcairo2-dev pkg-config libsqlite3-dev
  xvfb
)
[ "${1:-}" = program ] || packages+=(
  pybind11-dev python3-dev python3-numpy python3-matplotlib python3-pandas
)
[ "${1:-}" = program ] || [ "${1:-}" = python ] || packages+=(
  libgtest-dev libbenchmark-dev
  python3-jsonschema python3-ezdxf
  chromium
)
[ "${1:-}" != slurm ] || packages+=(slurm-wlm munge)
command -v npm >/dev/null || packages+=(nodejs npm) # interactive part of reports, body data

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

command -v apt-get >/dev/null || {
  echo "error: this system has no apt-get; Loosefit is built on Debian 12" >&2
  echo "hint: install the equivalents of: ${missing[*]}" >&2
  exit 2
}
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "error: packages are missing and can only be installed as root" >&2
    echo "hint: as root: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 2
  }
  as_root=(sudo)
fi

echo "setup: installing ${#missing[@]} Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q </dev/null
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
