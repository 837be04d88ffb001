# SPDX-License-Identifier: BSD-3-Clause
"""What figures.py and its commands share: running programs, inputs, tables."""
import contextlib
import gzip
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile


class Run:
    """A program that has run: exit status, standard output, CPU seconds (user and system), peak memory in MB.

    The kernel counts this script's own memory, some 15 MB, as the least peak of what it starts.
    """

    def __init__(self, command, cpus=None):
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            pin = (lambda: os.sched_setaffinity(0, cpus)) if cpus else None
            process = subprocess.Popen([str(c) for c in command], stdout=out, stderr=err, preexec_fn=pin)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = self.status = os.waitstatus_to_exitcode(status)
            out.seek(0), err.seek(0)
            self.output, self.errors = out.read().decode(), err.read().decode(errors="replace")
        self.cpu = usage.ru_utime + usage.ru_stime
        self.peak = usage.ru_maxrss * 1024 / 1e6
        if self.status:
            note(f"{command[0]}: exit status {self.status}: {self.errors.strip()[:300]}")


def note(text):
    print(text, file=sys.stderr, flush=True)


def machine():
    """Of the machine as it is now, in a line."""
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if "model name" in line), "?")
    return f"{model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"


def print_table(columns, rows):
    print("| " + " | ".join(columns) + " |")
    print("|" + "---|" * len(columns))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)


@contextlib.contextmanager
def scratch_folder(where):
    folder = pathlib.Path(tempfile.mkdtemp(prefix="figures", dir=where))
    try:
        yield folder
    finally:
        shutil.rmtree(folder)


def find_model(models, name):
    """The file of a model: `name` as it stands, or NAME.obj or NAME.obj.gz in `models`, or in its folder NAME."""
    folder = pathlib.Path(models)
    inside = sorted((folder / name).glob("*.obj*")) if (folder / name).is_dir() else []
    for path in [folder / f"{name}.obj", folder / f"{name}.obj.gz", *inside, folder / name, pathlib.Path(name)]:
        if path.is_file():
            return path.resolve()
    sys.exit(f"no model {name} in {models}")


def unpacked(path, scratch):
    """The file itself, or if it ends in .gz a copy without that, among links to what lies beside it."""
    if path.suffix != ".gz":
        return path
    folder = pathlib.Path(tempfile.mkdtemp(dir=scratch))
    for neighbour in path.parent.iterdir():
        if neighbour != path:
            (folder / neighbour.name).symlink_to(neighbour)
    with gzip.open(path) as source, open(folder / path.stem, "wb") as copy:
        shutil.copyfileobj(source, copy)
    return folder / path.stem
