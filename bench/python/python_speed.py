#!/usr/bin/env python3
"""What the Python module takes beside the command and beside C++, as a table: labels of a million
particles, and a step of surface tension on them. Medians; interleaved, so that a machine that slows
down slows both.

Usage: python_speed.py BUILD_FOLDER    (with the targets meniscus, meniscus_python and
                                        surface_step_time built)
"""
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

build = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(build / "python"))

import meniscus
import numpy as np

EDGE = 100
REPETITIONS = 5


def million_particles():
    """A lattice with noise; the support radius is two spacings."""
    places = np.stack(np.meshgrid(*3 * [np.arange(float(EDGE))], indexing="ij"), axis=-1)
    noise = np.random.default_rng(1).uniform(-0.1, 0.1, places.shape)
    return meniscus.Snapshot((places + noise).reshape(-1, 3), support_radius=2.0)


def timed(act):
    start = time.perf_counter()
    act()
    return time.perf_counter() - start


def row(name, seconds):
    print(f"| {name} | {statistics.median(seconds):.3f} |")


def label_rows(file, folder):
    def by_command():
        subprocess.run([build / "bin/meniscus", "label", file, "-o", Path(folder) / "labelled", "-q"],
                       check=True)
        (Path(folder) / "labelled" / file.name).unlink() # else it is up to date

    def by_module():
        meniscus.write(meniscus.label(meniscus.read(file)).snapshot, file.with_suffix(".out"))

    times = [(timed(by_command), timed(by_module), timed(lambda: meniscus.label(state)))
             for state in [meniscus.read(file)] for _ in range(REPETITIONS)]
    for name, seconds in zip(("`meniscus label`: read, label, write", "the same in Python",
                              "`label` of arrays alone"), zip(*times)):
        row(name, seconds)


def step_rows(file, state):
    lists = meniscus.neighbors(state)
    tension = meniscus.SurfaceTension(spacing_ratio=2)
    in_cpp, in_python = [], []
    for _ in range(REPETITIONS):
        in_cpp.append(float(subprocess.run([build / "bin/surface_step_time", file], check=True,
                                           capture_output=True, text=True).stdout))
        in_python.append(statistics.median(timed(lambda: tension.step(
            state.positions, *lists, support_radius=2.0)) for _ in range(9)))
    row("a step of surface tension in C++", in_cpp)
    row("`SurfaceTension.step`", in_python)


with tempfile.TemporaryDirectory() as folder:
    state = million_particles()
    file = Path(folder) / "million.vtkhdf"
    meniscus.write(state, file)
    print(f"{state.size} particles, {len(meniscus.neighbors(state)[1])} neighbors\n")
    print("| what | median, s |\n|---|---|")
    label_rows(file, folder)
    step_rows(file, state)
