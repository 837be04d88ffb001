#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs packages that the build needs and this Debian or Ubuntu lacks. Asks nothing; a second run does nothing.
set -euo pipefail

packages=(cmake ninja-build g++ git ccache pkg-config
  libopenmesh-dev libeigen3-dev libembree-dev libpugixml-dev zlib1g-dev
  libcli11-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev)

# Tetrahedra (MULTIMESH_WITH_TETGEN). AGPL-3, unlike all the others.
packages+=(libtet1.5-dev)
# Exact coordinates (MULTIMESH_WITH_EXACT). LGPL-3 or GPL-2.
packages+=(libgmp-dev)

# HTML reports. NodeSource's nodejs brings an npm of its own, which Debian's npm conflicts with.
command -v npm >/dev/null || packages+=(nodejs npm)
# Needed only by tests: a browser (on Ubuntu it is a snap), other readers of mesh files (200 MB), doxygen. Elsewhere those
# tests are skipped without them.
grep -qx 'ID=debian' /etc/os-release 2>/dev/null &&
  packages+=(chromium fonts-dejavu-core gmsh python3-meshio doxygen)

if ! command -v dpkg-query >/dev/null; then
  echo "setup: not a Debian system; provide the equivalents of: ${packages[*]}" >&2
  exit 0
fi

installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || {
    echo "setup: run as root: apt-get install ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=3 \
    -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" </dev/null >>"$log" 2>&1
}

echo "setup: installing ${missing[*]} (up to 2 GB of disk, some minutes)"
apt update || true # a broken foreign repository need not matter: the installation decides
apt install -y --no-install-recommends "${missing[@]}" || {
  cat "$log" >&2
  echo "setup: apt-get install ${missing[*]} failed, see above" >&2
  exit 1
}
