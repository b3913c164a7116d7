#!/usr/bin/python3
"""Draws the plots of docs/sampling_schemes.md from what `meniscus_bench` measured.

Usage: plot_sampling_schemes.py STUDY.json FOLDER
(`meniscus_bench sampling-schemes SNAPSHOT... --json STUDY.json`)
Needs Debian's python3-matplotlib, hence the system's Python. The same numbers give the same bytes.
"""
import json
import pathlib
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_sampling_schemes.py: matplotlib is missing; install python3-matplotlib")
matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "meniscus"
import matplotlib.pyplot as plt

# On the circle Halton's sequence has one base, so the two plots share the names that both have.
STYLES = {
    "random": ("black", "o"),
    "table": ("tab:gray", "s"),
    "halton": ("tab:blue", "^"),
    "halton-3-2": ("tab:cyan", "v"),
    "halton-2-5": ("tab:green", "<"),
    "halton-3-5": ("tab:olive", ">"),
    "halton-2-7": ("tab:purple", "P"),
    "halton-5-7": ("tab:pink", "X"),
    "halton-5-2": ("tab:orange", "d"),
    "halton-7-2": ("tab:brown", "p"),
    "blue-noise": ("tab:red", "D"),
}
SLOPES = {2: (-0.5, -1), 3: (-0.5, -0.75)}


def draw_panel(axes, rows, quantity):
    for scheme in dict.fromkeys(row["scheme"] for row in rows):
        color, marker = STYLES[scheme]
        own = [row for row in rows if row["scheme"] == scheme]
        axes.loglog([row["samples"] for row in own], [row[quantity] for row in own],
                    color=color, marker=marker, markersize=4, linewidth=1, label=scheme)
    axes.set_xlabel("directions a particle")
    axes.grid(True, which="major", linewidth=0.4)


def draw_slopes(axes, dimension, rows, quantity):
    """Dotted lines for orientation, one above and one below what was measured."""
    first = min(row["samples"] for row in rows)
    last = max(row["samples"] for row in rows)
    values = [row[quantity] for row in rows if row["samples"] == first]
    for start, slope in zip((2 * max(values), min(values) / 2), SLOPES[dimension]):
        end = start * (last / first) ** slope
        axes.loglog([first, last], [start, end], color="0.5", linestyle=":", linewidth=1, zorder=0)
        axes.annotate(f"slope {slope:g}", (last, end), color="0.4", fontsize=8,
                      xytext=(16, 0), textcoords="offset points", va="center")


def rows_of(tables, quantity):
    """One for each scheme and number of samples, of both dimensions."""
    return [{"scheme": row["scheme"], "dimension": dimension, "samples": int(samples),
             quantity: row[samples]}
            for dimension in (2, 3)
            for row in tables[f"{quantity}_{dimension}d"]["rows"]
            for samples in sorted((key for key in row if key.isdigit()), key=int)]


def draw(tables, quantity, labels, file):
    rows = rows_of(tables, quantity)
    figure, panels = plt.subplots(1, 2, figsize=(10, 5.4))
    entries = {}
    for axes, dimension in zip(panels, (2, 3)):
        own = [row for row in rows if row["dimension"] == dimension]
        draw_panel(axes, own, quantity)
        draw_slopes(axes, dimension, own, quantity)
        axes.set_title(f"{dimension}D")
        axes.set_ylabel(labels[dimension])
        handles, names = axes.get_legend_handles_labels()
        entries.update(zip(names, handles))
    names = [name for name in STYLES if name in entries]
    figure.legend([entries[name] for name in names], names, loc="lower center", ncol=6,
                  frameon=False)
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    figure.savefig(file, metadata={"Date": None})
    plt.close(figure)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: plot_sampling_schemes.py STUDY.json FOLDER")
    tables = {table["name"]: table
              for table in json.loads(pathlib.Path(sys.argv[1]).read_text())["tables"]}
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    error = "error of lambda, root mean square"
    draw(tables, "error", {2: error, 3: error}, folder / "sampling_error.svg")
    draw(tables, "discrepancy", {2: "star discrepancy", 3: "spherical cap discrepancy, largest"},
         folder / "sampling_discrepancy.svg")


main()
