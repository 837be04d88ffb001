#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fuzzes for some seconds (default 60): scripts of operations on trees, then readers of files. New findings are left
# in build/fuzz/; a crash ends the run with an error and names the file to keep in test/fuzz/crashes/.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}

command -v clang++ >/dev/null || {
  echo "fuzz: clang++ with libFuzzer is missing; on Debian: apt-get install clang" >&2
  exit 1
}
scripts/setup-debian.sh
cmake --preset fuzz
cmake --build --preset fuzz --target fuzz_operations fuzz_readers

run() {
  mkdir -p "build/fuzz/$2"
  "build/fuzz/test/fuzz/$1" "build/fuzz/$2" "test/fuzz/$2" "-max_total_time=$seconds" -print_final_stats=1 \
    "-artifact_prefix=build/fuzz/$1-" "${@:3}"
}
run fuzz_operations corpus -max_len=400
run fuzz_readers files -max_len=4000 -timeout=10 -rss_limit_mb=2048
