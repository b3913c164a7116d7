"""Surface tension in the step of a solver."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _meniscus
from .lines import Line

surface_options: dict[str, dict] = _meniscus.surface_options
"""Options of `SurfaceTension` by name: default, the 2020 paper's choice, unit, range, meaning."""


@dataclass(eq=False)
class Surface:
    """What a step found, in slots: one for each particle that the line let through, in the order
    of particles. `count` is the number of particles.

    particle: of each slot, uint32. surface_class: 1 covered, 2 surface, uint8.
    uncovered_fraction: lambda, 0 to 1. normal: (slots, dimension), out of the fluid; 0 where
    covered. curvature: mean curvature in 1/m, positive for a drop. force: (slots, dimension), N.
    """

    particle: NDArray
    surface_class: NDArray
    uncovered_fraction: NDArray
    normal: NDArray
    curvature: NDArray
    force: NDArray
    count: int

    def of_particles(self, name: str) -> NDArray:
        """An array of the slots, by its name, as one over all particles: zeros for others."""
        slots = getattr(self, name)
        values = np.zeros((self.count, *slots.shape[1:]), slots.dtype)
        values[self.particle] = slots
        return values


class SurfaceTension:
    """Surface tension of one fluid, with the memory that it needs: called once each step.

    dimension: 2 or 3. dtype: float32 or float64, of all reals that go in and out. line: a line of
    your own; without it the one that ships for the dimension and `spacing_ratio`. paper: all
    choices as in the 2020 paper. threads: 0 takes all that OpenMP offers. options: by the names of
    `surface_options`, first of all `surface_tension` (sigma in N/m) and `spacing_ratio` (support
    radius over the spacing of particles at rest); k, d and what else a line sets may be given
    beside it. Warns where the line was not trained for the spacing_ratio. Raises InputError where
    an option is out of its range, TypeError where there is none of that name.

    >>> cube = np.stack(np.meshgrid(*3 * [np.arange(6.0)]), axis=-1).reshape(-1, 3)
    >>> from meniscus import neighbors
    >>> tension = SurfaceTension(surface_tension=0.072, spacing_ratio=2)
    >>> surface = tension.step(cube, *neighbors(cube, 2.0), support_radius=2.0)
    >>> surface.of_particles("force").shape
    (216, 3)
    >>> SurfaceTension(tau=2)
    Traceback (most recent call last):
    ...
    meniscus.InputError: tau must be between 0 and 1, found 2
    """

    def __init__(self, dimension: int = 3, dtype: DTypeLike = np.float64, *,
                 line: Optional[Line] = None, paper: bool = False, threads: int = 0,
                 **options: Union[float, int, str]) -> None:
        self.dtype = np.dtype(dtype)
        if self.dtype not in (np.float32, np.float64):
            raise _meniscus.InputError(f"dtype must be float32 or float64, found {self.dtype}")
        for name in options:
            if name not in surface_options:
                raise TypeError(f"SurfaceTension has no option '{name}'; it has "
                                + ", ".join(surface_options))
        self._step = _meniscus.SurfaceTension(dimension, self.dtype == np.float64,
                                              line and line._model, paper, threads, options)
        if self._step.warning:
            warnings.warn(self._step.warning, stacklevel=2)

    def step(self, positions: ArrayLike, offsets: ArrayLike, indices: ArrayLike,
             masses: Optional[ArrayLike] = None, *, support_radius: Union[float, ArrayLike],
             ids: Optional[ArrayLike] = None, candidates: Optional[ArrayLike] = None,
             boundary_positions: Optional[ArrayLike] = None,
             boundary_offsets: Optional[ArrayLike] = None,
             boundary_indices: Optional[ArrayLike] = None,
             boundary_weights: Optional[ArrayLike] = None,
             balance_momentum: bool = False) -> Surface:
        """Finds the surface, and normal, curvature and force on it.

        positions: (N, dimension) or more columns, m. offsets, indices: neighbor lists as
        compressed rows, whole (j in the list of i as i in that of j), of whole numbers of 32 or 64
        bits; they may hold i itself and particles beyond the radius. masses: (N,), kg; None where
        all are equal. support_radius: h in m, or (N,). ids: uint32 (N,), where the solver sorts its
        particles. candidates: uint8 (N,), the solver's own classification by the first line.

        boundary_positions: (B, as positions). boundary_offsets, boundary_indices: boundary
        particles around each particle. boundary_weights: (B,), how many fluid particles each
        stands for, psi_b / m (Akinci et al. 2012); None: 1.

        balance_momentum takes net force and torque out of each connected component of fluid that
        touches no boundary.

        Arrays that are contiguous and of the object's dtype, indices of 32 bits, are read where
        they lie, others are copied. Raises InputError, naming the array, where one has another
        shape or type than it must or a list names a particle that does not exist. Finite input
        never gives NaN; `check` tells what else may be wrong.
        """
        given = {name: value for name, value in locals().items()
                 if name not in ("self", "balance_momentum")}
        return Surface(**self._step.step(given, balance_momentum))

    def check(self, positions: ArrayLike, offsets: ArrayLike, indices: ArrayLike,
              masses: Optional[ArrayLike] = None, *, support_radius: Union[float, ArrayLike],
              ids: Optional[ArrayLike] = None, candidates: Optional[ArrayLike] = None,
              boundary_positions: Optional[ArrayLike] = None,
              boundary_offsets: Optional[ArrayLike] = None,
              boundary_indices: Optional[ArrayLike] = None,
              boundary_weights: Optional[ArrayLike] = None) -> None:
        """Looks at all that `step` reads: finite positions, positive masses and radii, each pair in
        both lists and once, as many neighbors as `spacing_ratio` says. For while a solver is
        written; takes about as long as a step. Raises InputError, naming the first that is
        wrong."""
        self._step.check({name: value for name, value in locals().items() if name != "self"})

    def reserve(self, particles: int, neighbors: int) -> None:
        """Room for so many particles with so many neighbors each."""
        self._step.reserve(particles, neighbors)

    def set_samples(self, samples: int) -> None:
        """Samples a particle from now on, 4 to 16384."""
        self._step.set_samples(samples)

    def set_line(self, k: float, d: float) -> None:
        """Another first line from now on; the second, where there is one, stays."""
        self._step.set_line(k, d)

    def set_surface_tension(self, surface_tension: float) -> None:
        """Sigma in N/m from now on. As all of these, raises InputError, naming the range, where it
        is out of it, and changes nothing then."""
        self._step.set_surface_tension(surface_tension)

    def set_contact_angle(self, contact_angle: float) -> None:
        """Of walls from now on, in degrees."""
        self._step.set_contact_angle(contact_angle)

    def set_fade(self, fade: float) -> None:
        """How far forces fade towards covered particles from now on (option `fade`)."""
        self._step.set_fade(fade)

    def set_smoothing(self, normal_passes: int, curvature_passes: int) -> None:
        """Passes over normals and curvatures from now on."""
        self._step.set_smoothing(normal_passes, curvature_passes)
