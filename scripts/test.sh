#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds everything and runs all tests; with --asan a second time under ASan and UBSan.
set -euo pipefail
cd "$(dirname "$0")/.."

presets=(release)
for argument in "$@"; do
  case $argument in
    --asan) presets+=(asan) ;;
    *)
      echo "usage: scripts/test.sh [--asan]" >&2
      exit 2
      ;;
  esac
done

scripts/setup-debian.sh
for preset in "${presets[@]}"; do
  cmake --preset "$preset"
  cmake --build --preset "$preset"
done
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
