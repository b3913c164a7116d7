#!/usr/bin/env python3
"""Draws docs/images/pipeline.svg: what goes through which verb of `meniscus`, and into a solver."""
from pathlib import Path

WIDTH, HEIGHT = 130, 40
COLUMN, ROW = 172, 84
VERB, FILE = "#d55e00", "#0072b2"

# Column, row, words, and whether it is a verb.
BOXES = {
    "simulate": (0, 0, "simulate", True),
    "own": (0, 1, "your solver's files", False),
    "snapshots": (1, 0.5, "snapshots", False),
    "label": (2, 0.5, "label", True),
    "labelled": (3, 0.5, "labelled snapshots", False),
    "train": (4, 0, "train", True),
    "audit": (4, 1, "audit", True),
    "model": (5, 0, "model.json", False),
    "errors": (5, 1, "errors by scene", False),
    "export": (6, 0, "export", True),
    "header": (7, 0, "coefficient header", False),
    "runtime": (7, 1, "runtime/ in a step", True),
}
ARROWS = ["simulate snapshots", "own snapshots", "snapshots label", "label labelled", "labelled train",
          "labelled audit", "train model", "model audit", "model export", "export header", "audit errors",
          "header runtime"]


def middle(name):
    column, row, _, _ = BOXES[name]
    return 75 + COLUMN * column, 40 + ROW * row


def arrow(start, end):
    (x1, y1), (x2, y2) = middle(start), middle(end)
    if x1 < x2:
        x1, x2 = x1 + WIDTH / 2, x2 - WIDTH / 2 - 6
    elif x1 > x2:
        x1, y1, x2 = x1 - WIDTH / 4, y1 + HEIGHT / 2, x2 + WIDTH / 2 + 6
    else:
        y1, y2 = y1 + HEIGHT / 2, y2 - HEIGHT / 2 - 6
    return f'<line x1="{x1:g}" y1="{y1:g}" x2="{x2:g}" y2="{y2:g}" marker-end="url(#tip)"/>'


def box(name):
    x, y = middle(name)
    _, _, words, is_verb = BOXES[name]
    color = VERB if is_verb else FILE
    return (f'<rect x="{x - WIDTH / 2:g}" y="{y - HEIGHT / 2:g}" width="{WIDTH}" height="{HEIGHT}" '
            f'rx="{20 if is_verb else 3}" fill="#ffffff" stroke="{color}"/>\n'
            f'<text x="{x:g}" y="{y + 4:g}" fill="{color}" stroke="none">{words}</text>')


def main():
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="1354" height="166" viewBox="0 0 1354 166" '
        'font-family="Arial, Helvetica, sans-serif" font-size="12" text-anchor="middle">',
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        '<marker id="tip" viewBox="0 0 8 8" refX="1" refY="4" markerWidth="8" markerHeight="8" orient="auto">'
        '<path d="M0 0 L8 4 L0 8 z" fill="#555555"/></marker>',
        '<g stroke="#555555" stroke-width="1.2">', *(arrow(*names.split()) for names in ARROWS), "</g>",
        '<g stroke-width="1.5">', *map(box, BOXES), "</g>", "</svg>"]
    target = Path(__file__).parents[1] / "docs/images/pipeline.svg"
    target.write_text("\n".join(lines) + "\n")


main()
