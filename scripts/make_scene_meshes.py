#!/usr/bin/env python3
"""Writes the OBJ meshes of configs/scenes/meshes, in metres, y upward:

    scripts/make_scene_meshes.py configs/scenes/meshes
"""
import math
import sys
from pathlib import Path


def write(path, comment, vertices, faces):
    lines = [f"# {comment}"]
    lines += ["v " + " ".join(f"{x:.6g}" for x in vertex) for vertex in vertices]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def plate_with_hole(half_width=0.5, half_hole=0.12):
    signs = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    vertices = [(half * x, 0, half * z) for half in (half_width, half_hole) for x, z in signs]
    return vertices, [(k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k) for k in range(4)]


def hyperbolic_paraboloid(steepness=0.3, top=1.3, cells=12):
    """Closed container over a square of half width 1 whose bottom is y = steepness (x^2 - z^2)."""
    side = [2 * k / cells - 1 for k in range(cells + 1)]
    vertices = [(x, steepness * (x * x - z * z), z) for x in side for z in side]
    row = cells + 1
    faces = [(i * row + k, (i + 1) * row + k, (i + 1) * row + k + 1, i * row + k + 1)
             for i in range(cells) for k in range(cells)]
    corners = len(vertices)
    vertices += [(-1, top, -1), (1, top, -1), (1, top, 1), (-1, top, 1)]
    faces.append(tuple(corners + k for k in range(4)))
    edges = [[i * row for i in range(row)], [cells * row + k for k in range(row)],
             [i * row + cells for i in reversed(range(row))], [k for k in reversed(range(row))]]
    for k, edge in enumerate(edges):  # fans from one upper corner, then the rest of the side
        faces += [(a, b, corners + k) for a, b in zip(edge, edge[1:])]
        faces.append((edge[-1], corners + (k + 1) % 4, corners + k))
    return vertices, faces


def glass(parts=32, base=0.8, rim=1.06, height=2.22):
    """A tumbler of revolution with a thin wall."""
    angles = [2 * math.pi * k / parts for k in range(parts)]
    vertices = [(r * math.cos(a), y, r * math.sin(a))
                for r, y in ((base, 0), (rim, height)) for a in angles]
    faces = [tuple(range(parts))]
    faces += [(k, (k + 1) % parts, parts + (k + 1) % parts, parts + k) for k in range(parts)]
    return vertices, faces


def channel():
    """An inclined channel, open above and at its lower end, which lies above the glass."""
    back, front, half, top = -3.7, -0.5, 0.6, 5
    vertices = [(back, 3.8, -half), (back, 3.8, half), (front, 3, half), (front, 3, -half),
                (back, top, -half), (back, top, half), (front, top, half), (front, top, -half)]
    return vertices, [(0, 1, 2, 3), (0, 1, 5, 4), (1, 2, 6, 5), (0, 3, 7, 4)]


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for make in (plate_with_hole, hyperbolic_paraboloid, glass, channel):
        name = make.__name__
        write(Path(sys.argv[1]) / f"{name}.obj",
              f"{name.replace('_', ' ')}, made by scripts/make_scene_meshes.py", *make())
