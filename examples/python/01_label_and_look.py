#!/usr/bin/env python3
"""Labels a snapshot, of PySPH or of any other solver, and draws its surface.

Usage: 01_label_and_look.py SNAPSHOT PICTURE.png
"""
import sys

import matplotlib

matplotlib.use("Agg") # draws into files
import matplotlib.pyplot as plt
import meniscus

state = meniscus.read(sys.argv[1])
labels = meniscus.label(state, normals=True)
surface = labels.surface == 1
print(f"{state.size} particles in {state.dimension}D, {surface.sum()} surface")

x, y = state.positions.T[:2]
figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
points = axes.scatter(x, y, s=4, c=labels.uncovered_fraction, cmap="viridis")
axes.quiver(x[surface], y[surface], *labels.normal[surface].T[:2], width=0.002)
if state.boundary is not None:
    axes.scatter(*state.boundary.T[:2], s=2, c="0.7")
axes.set_aspect("equal")
axes.set_xlabel("x in m")
axes.set_ylabel("y in m")
figure.colorbar(points, label="uncovered fraction")
figure.savefig(sys.argv[2], dpi=150)
