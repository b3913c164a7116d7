"""The line that finds candidates of the surface: y <= k x + d in the plane of two features."""
from __future__ import annotations

import json
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Iterable, Optional, Sequence, Union

from numpy.typing import ArrayLike, NDArray

from . import _meniscus
from .snapshots import PathLike, Snapshot, as_snapshot

State = Union[Snapshot, PathLike]


class Line:
    """A trained line, perhaps with a second one for what the first lets through, and what it was
    trained on. Made by `Line.train`, `Line.load` or `Line.shipped`; never changed.

    >>> line = Line.shipped(dimension=3, spacing_ratio=2)
    >>> line.features, line.second_line["features"]
    (('mass_offset', 'neighbor_count'), ('mass_offset', 'direction_eigenvalue'))
    >>> print(line)
    y <= 63.522 x + 25.993; of these direction_eigenvalue <= 27.314 mass_offset + 4.7005
    """

    def __init__(self, model: _meniscus.Model) -> None:
        self._model = model

    @classmethod
    def train(cls, states: Iterable[State], *, label_threshold: float = 0.02,
              features: Sequence[str] = (), second_features: Sequence[str] = (),
              objective: str = "neyman-pearson", keep_k: Optional[Line] = None, seed: int = 1,
              scene: str = "") -> Line:
        """The line of fewest false positives that misses no surface particle of the states, which
        are labelled snapshots (`label(...).snapshot`) or files of them.

        Surface means an uncovered fraction above `label_threshold`. `features` are the line's two
        (the paper's where none are given), `second_features` those of a second line. `keep_k` keeps
        another line's slope and fits only d. `objective` and `seed` are as of the command. Raises
        InputError where there is no state, no surface or no interior particle, or where states are
        not labelled or differ in kind.
        """
        options = {"objective": objective, "label_threshold": label_threshold, "seed": seed,
                   "keep_k": keep_k and keep_k._model}
        return cls(_meniscus.train(states, options, list(features), list(second_features), scene))

    @classmethod
    def load(cls, path: PathLike) -> Line:
        """Reads a model file (JSON). Raises InputError, naming file and key, where it is none."""
        return cls(_meniscus.read_model(path))

    @classmethod
    def shipped(cls, dimension: int, spacing_ratio: float) -> Line:
        """The line that comes with the project for 2 or 3 dimensions and a support radius of so
        many spacings of particles at rest (the root of m / rho_0). Raises InputError beyond what
        they were trained for."""
        if dimension not in (2, 3):
            raise _meniscus.InputError(f"dimension must be 2 or 3, found {dimension}")
        folder = Path(__file__).parent / "models"
        models = [_meniscus.read_model(folder / f"surface_{dimension}d{width}.json")
                  for width in ("", "_wide", "_widest")]
        return cls(models[_meniscus.shipped_place(models, dimension, spacing_ratio)])

    @property
    def k(self) -> float:
        """Slope, in units of the second feature over the first."""
        return self._model.k

    @property
    def d(self) -> float:
        """Height at 0, in units of the second feature."""
        return self._model.d

    @property
    def surface_above(self) -> bool:
        """True where surface has y >= k x + d; never with the paper's features."""
        return self._model.surface_above

    @property
    def features(self) -> tuple[str, str]:
        """Names of x and y."""
        return self._model.features

    @property
    def second_line(self) -> Optional[dict]:
        """k, d, features and surface_above of the line for what the first lets through, or None."""
        return self._model.second_line

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._model.dimension

    @property
    def radius_ratio(self) -> float:
        """r2 / r1 of the labels that it was trained on."""
        return self._model.radius_ratio

    @property
    def label_threshold(self) -> float:
        """Surface means an uncovered fraction above this."""
        return self._model.label_threshold

    @property
    def boundary_weight(self) -> float:
        """Share of its volume that a boundary particle counts for."""
        return self._model.boundary_weight

    @property
    def spacing_ratio(self) -> Optional[tuple[float, float]]:
        """Smallest and largest support radius over spacing in training; None where not known."""
        return self._model.spacing_ratio

    @property
    def false_negatives(self) -> int:
        """Surface particles of the training set that it misses."""
        return self._model.false_negatives

    @property
    def false_positives(self) -> int:
        """Other particles of the training set that it lets through."""
        return self._model.false_positives

    def moved(self, by: float) -> Line:
        """The line with d higher by so many units of the second feature: above 0, the paper's line
        lets more through and misses less. The counts of errors stay those of the training.

        >>> line = Line.shipped(2, 2)
        >>> line.moved(3).d - line.d
        3.0
        """
        return Line(_meniscus.with_line(self._model, self.k, self.d + by))

    def audit(self, states: Iterable[State], *, label_threshold: Optional[float] = None,
              scene: str = "", threads: int = 0) -> dict:
        """Counts false negatives and false positives on labelled snapshots, all in memory or all in
        files: {"scenes": [...], "total": {...}, "warnings": [...], ...} with the keys of `meniscus
        audit --format json`. `label_threshold`: the line's own where none is given. Raises
        InputError where a state is not labelled or is not of the line's kind."""
        threshold = self.label_threshold if label_threshold is None else label_threshold
        return json.loads(_meniscus.audit(self._model, states, threshold, scene, threads))

    def to_json(self) -> str:
        """The text of a model file."""
        return self._model.to_json()

    def save(self, path: PathLike) -> None:
        """Writes a model file. Raises InputError where the path cannot be written to."""
        _meniscus.write_whole(path, self.to_json())

    def header(self, name: str = "SurfaceCoefficients") -> str:
        """The text of a C++ coefficient header with a struct of that name. Raises InputError where
        it is no name for one.

        >>> print(Line.shipped(3, 2).header("Mine")) # doctest: +ELLIPSIS
        // ...
        struct Mine {...
        """
        return self._model.header(name)

    def export(self, path: PathLike, name: str = "SurfaceCoefficients") -> None:
        """Writes a C++ coefficient header. Raises as `header` and `save` do."""
        _meniscus.write_whole(path, self.header(name))

    def __str__(self) -> str:
        return str(self._model)

    def __repr__(self) -> str:
        return f"<meniscus.Line {self} in {self.dimension}D>"


@dataclass(eq=False)
class Classes:
    """What a solver with a line would see. Arrays are (N,).

    surface: 1 for candidates, which the line lets through, uint8. valid: 0 where a particle was
    left out, uint8. neighbor_count: feature y. spacing_ratio: support radius over the spacing of
    particles at rest.
    """

    surface: NDArray
    valid: NDArray
    neighbor_count: NDArray
    spacing_ratio: float


def classify(state: Union[Snapshot, ArrayLike],
             support_radius: Union[float, ArrayLike, None] = None, *, line: Line,
             skip_invalid: bool = False, threads: int = 0) -> Classes:
    """Applies a line to a snapshot, or to positions (N, 2) or (N, 3) in m, in double. Warns where
    the state lies outside what the line was trained on. Raises InputError where there is no support
    radius, the line is of another dimension, or a position is not finite (unless skip_invalid)."""
    found = _meniscus.classify(as_snapshot(state, support_radius), line._model, skip_invalid,
                               threads)
    for text in found.pop("warnings"):
        warnings.warn(text, stacklevel=2)
    return Classes(**found)
