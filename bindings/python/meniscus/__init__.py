"""Finds the free surface of SPH fluids, and computes surface tension on it.

The pipeline of the command `meniscus`, over NumPy arrays:

>>> import meniscus, numpy as np
>>> cube = np.stack(np.meshgrid(*3 * [np.arange(8.0)]), axis=-1).reshape(-1, 3)
>>> labels = meniscus.label(cube, support_radius=2.0)
>>> int(labels.surface.sum()), len(cube)
(296, 512)
>>> line = meniscus.Line.train([labels.snapshot])
>>> line.false_negatives
0

`read`, `write`: snapshots of any format that the command knows.
`neighbors`, `boundary_neighbors`, `features`, `label`: neighbor lists, features and ground truth.
`Line`, `classify`: the line that finds candidates fast: trained, judged, exported, applied.
`SurfaceTension`: normals, curvature and force in the step of a solver.
`Simulation`: a scene, step by step.

Units are SI: lengths in m, masses in kg, forces in N (in two dimensions N per m of depth). Work is
done by threads of the module's own and without the interpreter's lock; no result depends on their
number. What is wrong with an input raises `InputError` (a `ValueError`), what fails on the way
`FailureError` (a `RuntimeError`); both are an `Error`, with the words of the command.
"""
from ._meniscus import Error, FailureError, InputError
from ._meniscus import version as __version__
from .labels import Labels, boundary_neighbors, feature_meanings, features, label, neighbors
from .lines import Classes, Line, classify
from .simulation import Simulation, StepReport
from .snapshots import Snapshot, read, write
from .surface import Surface, SurfaceTension, surface_options

__all__ = [
    "Classes", "Error", "FailureError", "InputError", "Labels", "Line", "Simulation", "Snapshot",
    "StepReport", "Surface", "SurfaceTension", "boundary_neighbors", "classify", "feature_meanings",
    "features", "label", "neighbors", "read", "surface_options", "write",
]
