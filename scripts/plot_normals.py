#!/usr/bin/python3
"""Draws the plot of docs/normals.md from what `meniscus_bench` measured.

Usage: plot_normals.py SCHEMES.json TIMES.json FOLDER
(`meniscus_bench normals-schemes --json SCHEMES.json`, `meniscus_bench normals-time --json TIMES.json`)
Needs Debian's python3-matplotlib, hence the system's Python. The same numbers give the same bytes.
"""
import json
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_normals.py: matplotlib is missing; install python3-matplotlib")
matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "meniscus"
import matplotlib.pyplot as plt

STYLES = {
    "random": ("black", "o"),
    "random table": ("tab:gray", "s"),
    "blue noise": ("tab:red", "D"),
    "Halton 2-3": ("tab:blue", "^"),
    "outward": ("tab:green", "P"),
    "exact": ("tab:purple", "*"),
}
# Ticks where they are in sight.
NANOSECONDS = [500, 700, 1000, 1500, 2000, 3000, 5000, 7000, 10000]
DEGREES = [1, 1.5, 2, 3, 5, 7, 10, 15]
TITLES = {0: "as sampled", 1: "one smoothing pass"}


def draw_panel(axes, rows):
    for scheme, (color, marker) in STYLES.items():
        own = [row for row in rows if row["scheme"] == scheme]
        axes.loglog([row["nanoseconds"] for row in own], [row["degrees"] for row in own],
                    color=color, marker=marker, markersize=5, linewidth=1, label=scheme)
    axes.set_xlabel("ns a surface particle")
    axes.grid(True, which="major", linewidth=0.4)
    for axis, ticks in ((axes.xaxis, NANOSECONDS), (axes.yaxis, DEGREES)):
        axis.set_major_locator(matplotlib.ticker.FixedLocator(ticks))
        axis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
        axis.set_minor_locator(matplotlib.ticker.NullLocator())


def read_table(file):
    """Rows of the first table by their first cell."""
    table = json.loads(pathlib.Path(file).read_text())["tables"][0]
    return {row["directions"]: row for row in table["rows"]}


def rows_of(degrees, times):
    smoothing = times["a smoothing pass"]["30"]
    return [{"scheme": scheme, "passes": passes, "degrees": row[samples][passes],
             "nanoseconds": times[scheme][samples] + passes * smoothing}
            for scheme, row in degrees.items()
            for samples in sorted(set(row) - {"directions"}, key=int) if row[samples] != ""
            for passes in TITLES]


def main():
    if len(sys.argv) != 4:
        sys.exit("usage: plot_normals.py SCHEMES.json TIMES.json FOLDER")
    rows = rows_of(read_table(sys.argv[1]), read_table(sys.argv[2]))
    folder = pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    figure, panels = plt.subplots(1, 2, figsize=(10, 5))
    for axes, passes in zip(panels, TITLES):
        draw_panel(axes, [row for row in rows if row["passes"] == passes])
        axes.set_title(TITLES[passes])
        axes.set_ylabel("mean angular error, degrees")
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="lower center", ncol=6, frameon=False)
    figure.tight_layout(rect=(0, 0.07, 1, 1))
    figure.savefig(folder / "normals.svg", metadata={"Date": None})
    plt.close(figure)


main()
