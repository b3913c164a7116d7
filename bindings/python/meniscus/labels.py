"""Ground truth: which particles are surface, and the features that tell of it."""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Optional, Sequence, Union

from numpy.typing import ArrayLike, NDArray

from . import _meniscus
from .snapshots import Snapshot, as_snapshot

feature_meanings: dict[str, str] = _meniscus.feature_meanings
"""What each feature is, by its name."""

PAPER_FEATURES = ("mass_offset", "neighbor_count")


def neighbors(state: Union[Snapshot, ArrayLike],
              support_radius: Union[float, ArrayLike, None] = None, *, skip_invalid: bool = False,
              threads: int = 0) -> tuple[NDArray, NDArray]:
    """The neighbors of each particle: those closer than `support_radius` (m; where it varies, than
    the mean of the pair's), of the same phase, without the particle itself.

    Returns (offsets, indices), compressed rows: uint64 of N + 1 and uint32; the neighbors of i are
    indices[offsets[i]:offsets[i + 1]], in an order that depends on the positions alone. Raises
    InputError where a position is not finite (unless skip_invalid) or the radius is not positive.

    >>> offsets, indices = neighbors([[0.0, 0], [1, 0], [3, 0]], support_radius=1.5)
    >>> offsets, indices
    (array([0, 1, 2, 2], dtype=uint64), array([1, 0], dtype=uint32))
    """
    return _meniscus.neighbors(as_snapshot(state, support_radius), skip_invalid, threads)


def boundary_neighbors(state: Snapshot, support_radius: Union[float, ArrayLike, None] = None, *,
                       skip_invalid: bool = False, threads: int = 0) -> tuple[NDArray, NDArray]:
    """The same for the boundary particles of the state around each of its particles."""
    return _meniscus.boundary_neighbors(as_snapshot(state, support_radius), skip_invalid, threads)


def features(state: Union[Snapshot, ArrayLike],
             support_radius: Union[float, ArrayLike, None] = None,
             names: Sequence[str] = PAPER_FEATURES, *, radius_ratio: float = 0.8,
             boundary_weight: float = 0.85, skip_invalid: bool = False,
             threads: int = 0) -> dict[str, NDArray]:
    """Features by name (`feature_meanings` has all), each (N,) of float64 without unit, as `label`
    stores them. `boundary_weight` is the share of its volume by which a boundary particle counts.
    Raises InputError where there is no feature of a name, and as `label` does.

    >>> features([[0.0, 0], [1, 0], [2, 0]], 1.5, ["neighbor_count"])["neighbor_count"]
    array([1., 2., 1.])
    """
    options = _options(names, radius_ratio, boundary_weight, skip_invalid, threads)
    found = _meniscus.features(as_snapshot(state, support_radius), options)
    return {name: found[name] for name in names}


@dataclass(eq=False)
class Labels:
    """Which particles are surface. Arrays are (N,) unless said otherwise.

    uncovered_fraction: lambda, the part of the sphere around the particle that no neighbor covers.
    surface: 1 where that is not zero, uint8. valid: 0 where a particle was left out, uint8.
    mass_offset, neighbor_count: the two features of the paper, without unit.
    features: others that were asked for, by name.
    normal: (N, 3), outward unit vectors of the surface particles, zeros for others and where so
        little is uncovered that it has no direction; None unless asked for.
    spacing_ratio: support radius over the spacing of particles at rest.
    snapshot: the labelled snapshot, as the command writes it: for `write` and `Line.train`.
    """

    uncovered_fraction: NDArray
    surface: NDArray
    valid: NDArray
    mass_offset: NDArray
    neighbor_count: NDArray
    features: dict[str, NDArray]
    normal: Optional[NDArray]
    spacing_ratio: float
    snapshot: Snapshot


def label(state: Union[Snapshot, ArrayLike], support_radius: Union[float, ArrayLike, None] = None,
          *, samples: Optional[int] = None, scheme: Optional[str] = None,
          seed: Optional[int] = None, radius_ratio: float = 0.8, normals: bool = False,
          features: Sequence[str] = (), boundary_weight: float = 0.85, skip_invalid: bool = False,
          threads: int = 0) -> Labels:
    """Decides which particles of a snapshot, or of positions (N, 2) or (N, 3) in m, are surface.

    Exact, unless one of `samples` (directions tested a particle), `scheme` or `seed` asks for Monte
    Carlo. `radius_ratio` is r2 / r1, of the covering spheres to h. Boundary particles of a snapshot
    cover; `boundary_weight` is the share of its volume by which one counts in the features.
    `threads` 0 takes all cores; the labels do not depend on it.

    Warns where the support radius is implausible. Raises InputError where there is none, where an
    option is out of range, or where a position is not finite (unless skip_invalid).

    >>> import numpy as np
    >>> square = np.stack(np.meshgrid(*2 * [np.arange(4.0)]), axis=-1).reshape(-1, 2)
    >>> label(square, support_radius=2.0).surface.reshape(4, 4)
    array([[1, 1, 1, 1],
           [1, 0, 0, 1],
           [1, 0, 0, 1],
           [1, 1, 1, 1]], dtype=uint8)
    """
    snapshot = as_snapshot(state, support_radius)
    options = _options(features, radius_ratio, boundary_weight, skip_invalid, threads)
    options["exact"] = samples is None and scheme is None and seed is None
    options.update((name, value) for name, value in
                   (("samples", samples), ("scheme", scheme), ("seed", seed)) if value is not None)
    found = _meniscus.label(snapshot, options, normals)
    labelled = Snapshot(**found.pop("snapshot"))
    _warn(labelled, found.pop("mean_neighbor_count"), found.pop("warnings"))
    return Labels(snapshot=labelled, **found)


def _options(features: Sequence[str], radius_ratio: float, boundary_weight: float,
             skip_invalid: bool, threads: int) -> dict:
    return {"exact": True, "samples": 100000, "scheme": "halton", "seed": 0,
            "features": list(features), "radius_ratio": radius_ratio,
            "boundary_weight": boundary_weight, "skip_invalid": skip_invalid, "threads": threads}


def _warn(labelled: Snapshot, mean: float, texts: Sequence[str]) -> None:
    lowest, highest = _meniscus.plausible_neighbor_counts(labelled.dimension)
    if labelled.size > 0 and not lowest <= mean <= highest:
        texts = [*texts, f"a mean neighbor count of {mean:.1f} is implausible in "
                         f"{labelled.dimension}D (expected {lowest:g} to {highest:g}); is the "
                         "support radius right?"]
    for text in texts:
        warnings.warn(text, stacklevel=3)
