#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the built program, and prints tables in markdown. docs/figures.md has them, and the commands.

    figures.py quality --evaluator EVAL MODEL...  decimates models, judges the results by another program
    figures.py peers RUNS.json                    compares what `quality --json` has written with other programs
    figures.py time MODEL... --peer P             CPU time side by side
    figures.py scale MODEL...                     time and memory per face; what `info` counts before and after
    figures.py repeat MODEL...                    is the output always the same?

A MODEL is a path, or the name of a file or folder in --models. A --peer is called `P IN OUT RATIO`.
"""
import argparse
import csv
import hashlib
import json
import os
import pathlib
import statistics

from measured import Run, find_model, machine, note, print_table, scratch_folder, unpacked

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def decimate(program, model, out, ratio, extra=(), cpus=None):
    return Run([program, "decimate", model, "-o", out, "--ratio", ratio, "--quiet", *extra], cpus)


def percent(ratio):
    return f"{100 * ratio:g} %"


# ---------------------------------------------------------------------------------------------- quality

def counts(reasons):
    return ", ".join(f"{n} {reason}" for reason, n in sorted(reasons.items(), key=lambda item: -item[1]) if n)


def target(report):
    """Whether the target was reached; if not, what stopped the run and what keeps the edges that are left."""
    if report["target_reached"]:
        return "reached"
    left = report.get("edges_left_by_what_keeps_them", {})
    wanted = report["options"].get("target_faces")
    return f"{report['faces']['after']} of {wanted}: {report['stopped_by']}" + (f" ({counts(left)})" if left else "")


def lost(verdict):
    """What the evaluator says was not kept."""
    kept = {"topology": "topology_preserved", "charts": "chart_topology_preserved", "seams": "seam_structure_preserved"}
    return [name for name, key in kept.items() if not verdict.get(key, True)]


def judge(options, model, out, name, ratio, extra):
    """One decimation and its evaluation, as a flat record; None if the program failed."""
    report_file = out.with_suffix(".json")
    run = decimate(options.program, model, out, ratio, ["--report", report_file, *extra])
    if run.status:
        return None
    report = json.loads(report_file.read_text())
    judged = Run([options.evaluator, model, out, "--samples", options.samples])
    if judged.status:
        return None
    found = json.loads(judged.output)
    texture = found.get("texture", {})
    original, decimated = (found[which].get("uv", {}) for which in ("original", "decimated"))
    more = lambda key: decimated.get(key, 0) - original.get(key, 0)
    return {
        "model": name, "percent": round(100 * ratio, 6), "options": " ".join(extra),
        "cpu": run.cpu, "peak": run.peak, "faces": report["faces"]["after"],
        "rms": found["distance"]["rms_rel"], "hausdorff": found["distance"]["hausdorff_rel"],
        "texture_deviation": texture.get("texture_dev_rms"), "psnr": texture.get("baked_psnr_db"),
        "crack": texture.get("seam_crack_rms"), "flips": more("flipped"), "zero": more("zero_area"),
        "lost": lost(found["verdict"]), "target": target(report), "refused": report["collapses"]["refused"],
    }


def shown(value, form):
    return "" if value is None else format(value, form)


def quality_row(r):
    return [r["model"], f"{r['percent']:g}", r["options"], f"{r['cpu']:.2f}", f"{r['peak']:.0f}", f"{r['rms']:.2e}",
            f"{r['hausdorff']:.2e}", shown(r["texture_deviation"], ".2e"), shown(r["psnr"], ".1f"),
            shown(r["crack"], ".1e"), f"{r['flips']:+d} / {r['zero']:+d}", ", ".join(r["lost"]) or "nothing",
            r["target"]]


def quality(options):
    columns = ["model", "%", "options", "CPU s", "peak MB", "RMS", "Hausdorff", "texture deviation", "PSNR dB",
               "seam crack", "UV flips / zero", "lost", "target"]
    variants = [f"--uv-weight {w}".split() for w in options.uv_weights] or [options.options.split()]
    records = []
    with scratch_folder(options.scratch) as scratch:
        for name in options.model:
            model = unpacked(find_model(options.models, name), scratch)
            for ratio in options.ratios:
                for extra in variants:
                    record = judge(options, model, scratch / "out.obj", name, ratio, extra)
                    note(f"{name} {percent(ratio)} {' '.join(extra)}: {'done' if record else 'FAILED'}")
                    if record:
                        records.append(record)
    print_table(columns, map(quality_row, records))
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(records, indent=1))


# ------------------------------------------------------------------------------------------------ peers

def read_peers(path):
    """Rows of the peers' figures, by model and percent; numbers as numbers, unknown ones as None."""
    cells = {}
    for row in csv.DictReader(line for line in open(path) if not line.startswith("#")):
        for key in ("rms", "texture_deviation", "psnr"):
            row[key] = float(row[key]) if row[key] else None
        cells.setdefault((row["model"], float(row["percent"])), []).append(row)
    return cells


def least(rows, key):
    return min((r[key] for r in rows if r[key] is not None), default=None)


def dominates(a, b):
    """Whether `a` is nearer in shape and in texture than `b`, in both."""
    return a["rms"] < b["rms"] and a["psnr"] > b["psnr"]


def over(ratio, within):
    return "" if ratio <= within else f"{100 * (ratio - 1):+.0f} %"


def ratios_row(cell, runs, rivals, within):
    """Ours over the best of theirs, for each of our runs: deviation / RMS; bold if both are within the tolerance."""
    best = [least(rivals, "texture_deviation"), least(rivals, "rms")]
    pairs = [(run["texture_deviation"] / best[0], run["rms"] / best[1]) for run in runs]
    shown_pairs = [f"**{d:.2f} / {r:.2f}**" if max(d, r) <= within else f"{d:.2f} / {r:.2f}" for d, r in pairs]
    missed = [min(d for d, _ in pairs), min(r for _, r in pairs), min(map(max, pairs))]
    return [cell[0], f"{cell[1]:g}", *shown_pairs, *(over(x, within) for x in missed)]


def pareto_row(cell, runs, rivals):
    rivals = [r for r in rivals if r["rms"] is not None and r["psnr"] is not None]
    if not rivals:
        return None
    theirs = [r["peer"] + ("" if r["kept"] == "yes" else "*") for r in rivals
              if not any(dominates(run, r) for run in runs)]
    ours = [f"{run['options'].split()[-1]}: {', '.join(b)}" for run in runs
            if (b := [r["peer"] + ("" if r["kept"] == "yes" else "*") for r in rivals if dominates(r, run)])]
    return [cell[0], f"{cell[1]:g}", str(len(rivals)), ", ".join(theirs) or "none", "; ".join(ours) or "none"]


def peers(options):
    cells, rivals = {}, read_peers(options.figures)
    for record in json.loads(pathlib.Path(options.runs).read_text()):
        cells.setdefault((record["model"], record["percent"]), []).append(record)
    cells = {cell: runs for cell, runs in cells.items() if cell in rivals}
    if not cells:
        raise SystemExit("none of these models and ratios has figures of other programs")
    variants = [run["options"].replace("--uv-weight", "weight") or "default" for run in next(iter(cells.values()))]
    print(f"Texture deviation / RMS, each relative to the best of other programs; bold: both at most "
          f"{options.within:g}. Missed by: at the best weight for it.\n")
    print_table(["model", "%", *variants, "deviation missed by", "RMS missed by", "both at one weight missed by"],
                [ratios_row(cell, runs, rivals[cell], options.within) for cell, runs in cells.items()])
    print("\nRMS and PSNR together; * did not keep topology, charts, seams or orientation.\n")
    rows = (pareto_row(cell, runs, rivals[cell]) for cell, runs in cells.items())
    print_table(["model", "%", "others", "not beaten in both at any weight", "better in both than ours, at weight"],
                [row for row in rows if row])


# ------------------------------------------------------------------------------------------------- time

def named(text):
    """NAME=PATH, or PATH alone."""
    name, _, path = text.rpartition("=")
    return name or pathlib.Path(path).name, path


def time_all(options, commands, ratio, out):
    """Runs of every program, in turn, so that a ratio compares runs of the same minute."""
    runs = {name: [] for name in commands}
    for _ in range(options.repetitions):
        for name, command in commands.items():
            runs[name].append(command(ratio, out))
    return runs


def time_rows(model, ratio, runs):
    base = next(iter(runs.values()))
    for name, mine in runs.items():
        seconds = [r.cpu for r in mine]
        over = [r.cpu / b.cpu for r, b in zip(mine, base)]
        yield [model, percent(ratio), name, f"{statistics.median(seconds):.3f}",
               f"{min(seconds):.3f} to {max(seconds):.3f}", f"{statistics.median(over):.2f}",
               f"{statistics.median(r.peak for r in mine):.0f}"]


def time(options):
    rows = []
    with scratch_folder(options.scratch) as scratch:
        for name in options.model:
            model = unpacked(find_model(options.models, name), scratch)
            ours = lambda ratio, out: decimate(options.program, model, out, ratio, options.options.split())
            commands = {"multimesh": ours}
            for peer, path in map(named, options.peer):
                commands[peer] = lambda ratio, out, path=path: Run([path, model, out, ratio])
            for ratio in options.ratios:
                rows += time_rows(name, ratio, time_all(options, commands, ratio, scratch / "out.obj"))
                note(f"{name} {percent(ratio)}: done")
    print(f"Medians of {options.repetitions}; {machine()}.\n")
    base = "multimesh" if options.peer else "first"
    print_table(["model", "to", "program", "CPU s", "range", f"/ {base}", "peak MB"], rows)


# ------------------------------------------------------------------------------------------------ scale

KEPT = {"surface": ["components", "euler_characteristic", "boundary_loops", "genus"],
        "texture": ["charts", "euler_characteristic", "boundary_loops"], "seams": ["curves", "ends", "junctions"]}


def info(program, model):
    return json.loads(Run([program, "info", "--json", model]).output)["meshes"]


def kept_counts(found):
    return {f"{mesh} {key}": found[mesh][key] for mesh, keys in KEPT.items() if found.get(mesh) for key in keys}


def changes(before, after):
    lists = [f"{key} {n} to {after.get(key)}" for key, n in before.items() if after.get(key) != n]
    return ", ".join(lists) or "nothing"


def scale(options):
    rows = []
    with scratch_folder(options.scratch) as scratch:
        for name in options.model:
            path = find_model(options.models, name)
            model, out = unpacked(path, scratch), scratch / "out.obj"
            before = info(options.program, model)
            faces = before["surface"]["faces"]
            for ratio in options.ratios:
                run = decimate(options.program, model, out, ratio, options.options.split())
                after = info(options.program, out)
                left = after["surface"]["faces"]
                rows.append([path.name, f"{faces:,}", percent(ratio), f"{left:,}", f"{run.cpu:.2f}",
                             f"{1e6 * run.cpu / faces:.2f}", f"{run.peak:.0f}", f"{1e6 * run.peak / faces:.0f}",
                             changes(kept_counts(before), kept_counts(after))])
                note(f"{name} {percent(ratio)}: done")
    print(machine() + "\n")
    print_table(["file", "faces", "to", "faces left", "CPU s", "µs per face", "peak MB", "bytes per face", "changed"],
                rows)


# ----------------------------------------------------------------------------------------------- repeat

def repeat(options):
    rows = []
    with scratch_folder(options.scratch) as scratch:
        for name in options.model:
            model, out = unpacked(find_model(options.models, name), scratch), scratch / "out.obj"
            for ratio in options.ratios:
                for where, cpus in (("any core", None), ("one core", {min(os.sched_getaffinity(0))})):
                    sums = set()
                    for _ in range(options.repetitions):
                        decimate(options.program, model, out, ratio, options.options.split(), cpus)
                        sums.add(hashlib.sha256(out.read_bytes()).hexdigest()[:16])
                        out.unlink()
                    rows.append([name, percent(ratio), where, str(options.repetitions), " ".join(sorted(sums))])
    print_table(["model", "to", "on", "runs", "sha256 begins"], rows)


# ------------------------------------------------------------------------------------------------- main

def add_runner(commands, name, function, ratios, repetitions):
    parser = commands.add_parser(name)
    parser.set_defaults(function=function)
    parser.add_argument("model", nargs="+")
    parser.add_argument("--program", default=ROOT / "build/release/tools/multimesh")
    parser.add_argument("--models", default=ROOT.parent / "shared/data/bench", help="folder of models")
    parser.add_argument("--ratios", nargs="+", type=float, default=ratios)
    parser.add_argument("--repetitions", type=int, default=repetitions)
    parser.add_argument("--options", default="", help="more options of `multimesh decimate`, in one argument")
    parser.add_argument("--scratch", help="folder for temporary files")
    return parser


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    command = add_runner(commands, "quality", quality, [0.5, 0.1, 0.02], 1)
    command.add_argument("--evaluator", required=True, help="called EVALUATOR IN OUT --samples N; prints JSON")
    command.add_argument("--samples", type=int, default=60000)
    command.add_argument("--uv-weights", nargs="+", default=[], help="one run for each, in place of --options")
    command.add_argument("--json", help="write all runs here, for `peers`")
    command = commands.add_parser("peers")
    command.set_defaults(function=peers)
    command.add_argument("runs")
    command.add_argument("--figures", default=HERE / "peers.csv")
    command.add_argument("--within", type=float, default=1.1)
    command = add_runner(commands, "time", time, [0.1], 5)
    command.add_argument("--peer", action="append", default=[], help="[NAME=]PROGRAM")
    add_runner(commands, "scale", scale, [0.1], 1)
    add_runner(commands, "repeat", repeat, [0.1], 10)
    options = parser.parse_args()
    options.function(options)


if __name__ == "__main__":
    main()
