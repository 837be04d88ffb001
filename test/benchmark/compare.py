#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the collapse loop's variants side by side and prints the ratios of their CPU times to bare OpenMesh.

    compare.py build/release/test/benchmark/bench_collapse_loop [--shape sphere] [--size 256]
               [--repetitions 5] [--variants bare root uv uv+seams decimater] [--json FILE]

Every run is a process of its own, so that each has a fresh heap and a peak memory of its own; the variants
take turns, so that a ratio compares runs of the same minute. Medians over the repetitions.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

VARIANTS = ["bare", "root", "uv", "uv+seams", "decimater"]


def run(program, name):
    """One run of one benchmark: its counters, CPU time in seconds and peak memory in MiB."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        exact = "^" + name.replace("+", "[+]") + "$"
        process = subprocess.Popen(
            [program, "--benchmark_filter=" + exact, "--benchmark_min_time=0.01",
             "--benchmark_out=" + out.name, "--benchmark_out_format=json"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{program} failed on {name}")
        results = json.load(open(out.name))["benchmarks"]
    if not results:
        sys.exit(f"no benchmark named {name}")
    result = results[0]
    result["seconds"] = result["cpu_time"] / 1000
    result["peak_mib"] = usage.ru_maxrss / 1024
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--shape", default="sphere")
    parser.add_argument("--size", default="256")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--variants", nargs="+", default=VARIANTS)
    parser.add_argument("--json", help="write all runs here")
    options = parser.parse_args()

    runs = {v: [] for v in options.variants}
    for repetition in range(options.repetitions):
        for variant in options.variants:
            runs[variant].append(run(options.program, f"{options.shape}/{variant}/{options.size}"))
        print(f"repetition {repetition + 1} of {options.repetitions}, load {os.getloadavg()[0]:.1f}",
              file=sys.stderr)

    base = options.variants[0]
    print(f"{options.shape} {options.size}: {int(runs[base][0]['faces'])} faces, "
          f"medians of {options.repetitions}, CPU time")
    print(f"{'variant':12}{'collapses/s':>12}{'seconds':>9}{'time/' + base:>11}{'(range)':>15}"
          f"{'rate/' + base:>11}{'faces left':>11}{'map B/face':>11}{'peak MiB':>9}")
    for variant, list_of_runs in runs.items():
        ratios = [r["seconds"] / b["seconds"] for r, b in zip(list_of_runs, runs[base])]
        rates = [r["collapses/s"] / b["collapses/s"] for r, b in zip(list_of_runs, runs[base])]
        median = lambda key: statistics.median(r.get(key, 0) for r in list_of_runs)
        spread = f"{min(ratios):.2f}-{max(ratios):.2f}"
        print(f"{variant:12}{median('collapses/s'):12.0f}{median('seconds'):9.3f}{statistics.median(ratios):11.3f}"
              f"{spread:>15}{statistics.median(rates):11.3f}{int(median('faces_left')):11}"
              f"{median('map_bytes/face'):11.1f}{median('peak_mib'):9.0f}")
    if options.json:
        json.dump({"load": os.getloadavg(), "runs": runs}, open(options.json, "w"), indent=1)


if __name__ == "__main__":
    main()
