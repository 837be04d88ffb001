#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the program and decimates the bundled textured cow to a tenth of its faces, into build/demo/.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup-debian.sh
cmake --preset release
cmake --build --preset release --target tools/all

run() {
  echo
  echo "\$ $*"
  "$@"
}
multimesh=build/release/tools/multimesh
mkdir -p build/demo
run $multimesh info examples/data/spot/spot.obj
run $multimesh decimate examples/data/spot/spot.obj -o build/demo/spot.obj --ratio 0.1 \
  --report build/demo/report.json --report-html build/demo/report.html
run $multimesh info build/demo/spot.obj
run $multimesh compare examples/data/spot/spot.obj build/demo/spot.obj
echo
echo "Look at build/demo/report.html in a browser; build/demo/report.json says what was done."
