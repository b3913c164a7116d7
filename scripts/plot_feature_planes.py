#!/usr/bin/python3
"""Draws the plot of docs/accuracy.md: particles in the planes of both lines at three compressions.

Usage: plot_feature_planes.py MODEL.json FOLDER LABELLED...   (`label --features direction_eigenvalue`)
Needs Debian's python3-matplotlib and python3-h5py, hence the system's Python. The same input gives the
same bytes.
"""
import json
import pathlib
import sys

try:
    import h5py
    import matplotlib
except ImportError as error:
    sys.exit(f"plot_feature_planes.py: {error.name} is missing; install python3-{error.name}")
matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "meniscus"
import matplotlib.pyplot as plt

SHOWN = 3000  # particles of a panel
GROWS_WITH_COUNTS = {"neighbor_count", "direction_eigenvalue"}


def read_state(file, threshold):
    """Features as they would be at h = 2 spacings, and which particles are surface."""
    with h5py.File(file) as state:
        data, field = state["VTKHDF/PointData"], state["VTKHDF/FieldData"]
        radius, volume = field["support_radius"][0], field["particle_volume"][0]
        scale = 8 * volume / radius**3
        arrays = {name: data[name][:] * (scale if name in GROWS_WITH_COUNTS else 1)
                  for name in ("mass_offset", "neighbor_count", "direction_eigenvalue")}
        return arrays, data["uncovered_fraction"][:] > threshold


def draw_panel(axes, arrays, surface, line, title):
    step = max(1, len(surface) // SHOWN)
    x, y = (arrays[name][::step] for name in line["features"])
    for of_surface, color, name in ((False, "tab:gray", "interior"), (True, "tab:blue", "surface")):
        chosen = surface[::step] == of_surface
        axes.plot(x[chosen], y[chosen], ".", color=color, markersize=1.5, label=name,
                  rasterized=True)
    ends = [0, 0.8]
    axes.plot(ends, [line["k"] * end + line["d"] for end in ends], "-k", linewidth=1)
    axes.set_xlim(0, 0.8)
    axes.set_ylim(0, 48 if line["features"][1] == "neighbor_count" else 14)
    axes.set_title(title, fontsize=8)
    axes.set_xlabel(line["features"][0])


def main(model_file, folder, *files):
    model = json.loads(pathlib.Path(model_file).read_text())
    lines = [model, model["second_line"]]
    figure, grid = plt.subplots(2, len(files), figsize=(3.2 * len(files), 5.6), sharey="row")
    for column, file in enumerate(files):
        arrays, surface = read_state(file, model["label_threshold"])
        for row, line in enumerate(lines):
            draw_panel(grid[row][column], arrays, surface, line, pathlib.Path(file).stem)
    for row, line in enumerate(lines):
        grid[row][0].set_ylabel(line["features"][1])
    grid[0][-1].legend(markerscale=4, fontsize=7)
    figure.tight_layout()
    figure.savefig(pathlib.Path(folder) / "feature_planes.svg", metadata={"Date": None}, dpi=150)


main(*sys.argv[1:])
