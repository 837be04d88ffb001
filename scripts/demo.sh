#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the program and decimates the bundled textured cow to a tenth of its faces, into build/demo/.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup-debian.sh
viewer=ON
npm ping >/dev/null 2>&1 || {
  echo "demo: the npm registry cannot be reached; building without the viewer of the HTML reports" >&2
  viewer=OFF
}
cmake --preset release -DMULTIMESH_WITH_VIEWER=$viewer
cmake --build --preset release --target tools/all

run() {
  echo
  echo "\$ $*"
  "$@"
}
multimesh=build/release/tools/multimesh
mkdir -p build/demo
run $multimesh info examples/data/spot/spot.obj
page=()
[[ $viewer == OFF ]] || page=(--report-html build/demo/report.html)
run $multimesh decimate examples/data/spot/spot.obj -o build/demo/spot.obj --ratio 0.1 \
  --report build/demo/report.json "${page[@]}"
run $multimesh info build/demo/spot.obj
run $multimesh compare examples/data/spot/spot.obj build/demo/spot.obj
echo
[[ $viewer == OFF ]] || echo "Look at build/demo/report.html in a browser: the cow before and after, in 3D."
echo "build/demo/report.json says what was done."
