#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds everything and runs all tests; with --asan a second time under ASan and UBSan. Checks the formatting if
# clang-format is installed; with --tidy also runs clang-tidy on all sources, which takes long.
set -euo pipefail
cd "$(dirname "$0")/.."

presets=(release)
tidy=false
for argument in "$@"; do
  case $argument in
    --asan) presets+=(asan) ;;
    --tidy) tidy=true ;;
    *)
      echo "usage: scripts/test.sh [--asan] [--tidy]" >&2
      exit 2
      ;;
  esac
done

scripts/setup-debian.sh
if command -v clang-format > /dev/null && git rev-parse 2> /dev/null; then
  git ls-files -z '*.?pp' | xargs -0 clang-format --dry-run -Werror
else
  echo "no clang-format, or no checkout: the layout is not checked"
fi
for preset in "${presets[@]}"; do
  cmake --preset "$preset"
  cmake --build --preset "$preset"
done
if $tidy; then
  git ls-files '*.cpp' | while read -r file; do
    ! grep -q "/$file\"" build/release/compile_commands.json || echo "$file"
  done | xargs -n 1 nice clang-tidy -p build/release --quiet --warnings-as-errors='*'
fi
for preset in "${presets[@]}"; do
  log=build/$preset/ctest.log
  status=0
  ctest --preset "$preset" --no-tests=error -j "$(nproc)" | tee "$log" || status=$?
  # ctest lists skipped tests after its count: the count is repeated, so that it stands last.
  echo
  echo "$preset:"
  grep -E '^[0-9]+% tests passed|^Total Test time' "$log" || true
  ((status == 0)) || exit "$status"
done
