"""Snapshots: the state of a simulation at one instant, from files of any format and from arrays."""
from __future__ import annotations

import os
from dataclasses import dataclass, field, replace
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _meniscus

PathLike = Union[str, "os.PathLike[str]"]


@dataclass(eq=False)
class Snapshot:
    """The state of a simulation: positions, and whatever arrays there are beside them.

    positions: (N, 2) or (N, 3), m; float32 or float64, which is what files are written in.
    arrays: by name, (N,) or (N, components); names that mean something are `velocity`, `density`,
        `mass` (kg), `id`, `phase` and, where it varies, `support_radius` (m).
    boundary: particles of walls, (B, 2) or (B, 3), m; None where none are known.
    dimension: 2 or 3; as many as positions have coordinates where it is not given.
    support_radius: the radius h beyond which the kernel is zero, m; None where it varies. An array
        of N becomes `arrays["support_radius"]`.
    particle_spacing: initial distance of particles, m. particle_volume: of a particle at rest, m^3
        (in 2D m^2). time: s. scene: which simulation the state belongs to.
    provenance: what made the data, texts by name.

    >>> drop = Snapshot([[0, 0], [1, 0]], {"mass": [1.0, 1.0]}, support_radius=2)
    >>> drop.dimension, drop.size, drop.mass
    (2, 2, array([1., 1.]))
    """

    positions: NDArray
    arrays: dict[str, NDArray] = field(default_factory=dict)
    boundary: Optional[NDArray] = None
    dimension: int = 0
    support_radius: Optional[float] = None
    particle_spacing: Optional[float] = None
    particle_volume: Optional[float] = None
    time: Optional[float] = None
    scene: str = ""
    provenance: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.positions = as_reals(self.positions, "positions")
        self.arrays = {name: np.asarray(values) for name, values in self.arrays.items()}
        if self.boundary is not None:
            self.boundary = as_reals(self.boundary, "boundary")
        if self.dimension == 0:
            self.dimension = self.positions.shape[1] if self.positions.ndim == 2 else 3
        if self.support_radius is not None and np.ndim(self.support_radius) > 0:
            self.arrays["support_radius"] = np.asarray(self.support_radius)
            self.support_radius = None

    @property
    def size(self) -> int:
        """Number of particles, N."""
        return len(self.positions)

    @property
    def velocity(self) -> Optional[NDArray]:
        """(N, 3), m/s; None where there is none, as for the other arrays."""
        return self.arrays.get("velocity")

    @property
    def density(self) -> Optional[NDArray]:
        """(N,), kg/m^3."""
        return self.arrays.get("density")

    @property
    def mass(self) -> Optional[NDArray]:
        """(N,), kg."""
        return self.arrays.get("mass")

    @property
    def id(self) -> Optional[NDArray]:
        """(N,), a number of its own for each particle."""
        return self.arrays.get("id")

    @property
    def phase(self) -> Optional[NDArray]:
        """(N,); particles of different phase are no neighbors."""
        return self.arrays.get("phase")


def as_reals(values: ArrayLike, name: str) -> NDArray:
    """The array, in float64 unless it is float32. Raises InputError where it is not of numbers."""
    try:
        array = np.asarray(values)
        return array if array.dtype in (np.float32, np.float64) else array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise _meniscus.InputError(f"{name} must be an array of numbers: {error}") from None


def check_positive(name: str, value: Optional[float]) -> None:
    """Raises InputError where there is a value that is not positive and finite."""
    if value is not None and not 0 < value < np.inf:
        raise _meniscus.InputError(f"{name} must be positive and finite, found {value}")


def read(path: PathLike, *, support_radius: Optional[float] = None,
         particle_spacing: Optional[float] = None, particle_volume: Optional[float] = None,
         dimension: Optional[int] = None, scene: Optional[str] = None,
         frame: Optional[int] = None) -> Snapshot:
    """Reads a snapshot of any format, told by its content: the project's own .vtkhdf, legacy .vtk,
    .bgeo, PySPH's .hdf5, CSV with named columns. Positions are (N, 3) in the file's number type.

    The options stand in for what the file does not store, or in place of what it does: lengths in
    m, volume in m^3 (in 2D m^2). `frame` is the state to read of a file that holds several, from
    0; without, the last is. Raises InputError where the file is missing, damaged or of no known
    format, has no such state, or an option is not positive.

    >>> read("nowhere.vtk")
    Traceback (most recent call last):
    ...
    meniscus.InputError: nowhere.vtk: expected a file, found none; check the path
    """
    given = {"support_radius": support_radius, "particle_spacing": particle_spacing,
             "particle_volume": particle_volume}
    for name, value in given.items():
        check_positive(name, value)
    given.update(dimension=dimension, scene=scene)
    snapshot = Snapshot(**_meniscus.read(path, frame))
    if support_radius is not None:
        snapshot.provenance.pop("support_radius_from", None)
    return replace(snapshot, **{name: value for name, value in given.items() if value is not None})


def write(snapshot: Snapshot, path: PathLike) -> None:
    """Writes a .vtkhdf file (VTKHDF, which ParaView opens), whole or not at all; the same snapshot
    gives the same bytes. Raises InputError where the path cannot be written to, or an array has
    another number of rows than positions; FailureError where writing fails midway."""
    _meniscus.write(snapshot, path)


def as_snapshot(state: Union[Snapshot, ArrayLike],
                support_radius: Union[float, ArrayLike, None]) -> Snapshot:
    """The state with that support radius; its own where none is given. Positions alone make a
    state, too."""
    if not isinstance(state, Snapshot):
        return Snapshot(state, support_radius=support_radius)
    if support_radius is None:
        return state
    return replace(state, support_radius=support_radius)
