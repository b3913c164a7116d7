#!/usr/bin/python3
"""Tables of the docs that have a column for each number of directions, as `meniscus plot` takes them: a
row for each figure. Prints Markdown.

Usage: long_tables.py sampling QUANTITY   (docs/data/sampling_schemes.md, "error" or "discrepancy")
       long_tables.py normals             (docs/data/normals_schemes.md over the times of docs/normals.md)
"""
import re
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1] / "docs"
SAMPLING = {"error": {"3D: error of lambda, root mean square", "2D: error of lambda, root mean square"},
            "discrepancy": {"3D: cap discrepancy, largest", "2D: star discrepancy"}}
LEFT_OUT = {"halton-3-5", "halton-2-7", "halton-5-7"} # lie on the others; a plot has eight colors


def tables_of(page):
    """Rows of each table by its title, a dictionary each."""
    tables = {}
    lines = iter((DOCS / page).read_text().splitlines())
    title = heading = None
    for line in lines:
        if line.startswith("**"):
            title, heading = line.strip("*"), None
        elif line.startswith("|"):
            cells = [cell.strip(" *") for cell in line.strip("|").split("|")]
            if heading is None:
                heading = cells
                next(lines) # the line below it
                tables[title] = []
            else:
                tables[title].append(dict(zip(heading, cells)))
    return tables


def directions_of(row):
    """The columns that are a number of directions, where the row has a figure."""
    return [name for name, cell in row.items() if name.isdigit() and cell]


def print_rows(heading, rows):
    for cells in (heading, ["---"] * len(heading), *rows):
        print("|", " | ".join(map(str, cells)), "|")


def sampling(quantity):
    tables = tables_of("data/sampling_schemes.md")
    print_rows(["dimension", "scheme", "directions a particle", quantity],
               [(title.split(":")[0], row["scheme"], directions, row[directions])
                for title in sorted(SAMPLING[quantity]) for row in tables[title]
                if row["scheme"] not in LEFT_OUT for directions in directions_of(row)])


def normals():
    schemes = next(rows for title, rows in tables_of("data/normals_schemes.md").items()
                   if "h = 2 spacings" in title)
    times = {row["directions"]: row for title, rows in tables_of("normals.md").items() for row in rows
             if title and title.startswith("Nanoseconds")}
    smoothing = float(times["a smoothing pass"]["30"])
    rows = []
    for passes, panel in enumerate(("as sampled", "one smoothing pass")):
        for row in schemes:
            name = row["directions"]
            for directions in directions_of(row):
                degrees = re.split(r" / ", row[directions])[passes]
                nanoseconds = float(times[name][directions]) + passes * smoothing
                rows.append((panel, name, f"{nanoseconds:g}", degrees))
    print_rows(["normals", "directions", "ns a surface particle", "mean error, degrees"], rows)


if sys.argv[1:2] == ["sampling"] and sys.argv[2:] in (["error"], ["discrepancy"]):
    sampling(sys.argv[2])
elif sys.argv[1:] == ["normals"]:
    normals()
else:
    sys.exit("usage: long_tables.py sampling error|discrepancy, or normals")
