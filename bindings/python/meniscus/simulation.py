"""A scene that runs step by step, with its state as arrays."""
from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Mapping, Optional

import numpy as np
from numpy.typing import NDArray

from . import _meniscus
from .snapshots import PathLike, Snapshot


@dataclass
class StepReport:
    """What a step did. Times in s, speed in m/s, errors relative; `surface_particles` where the
    scene's surface is known."""

    time: float
    time_step: float
    pressure_iterations: int
    divergence_iterations: int
    density_error: float
    divergence_error: float
    converged: bool
    max_speed: float
    surface_particles: int


class Simulation:
    """A scene (JSON, docs/scenes.md of the project) from its first state on.

    variant: of those that the file names. changes: values by key, such as {"pressure.solver":
    "iisph"}; None takes a key out. threads: 0 takes all cores; no result depends on it. Raises
    InputError, naming file and key, where the scene cannot be read or filled.
    """

    def __init__(self, scene: PathLike, *, variant: str = "",
                 changes: Optional[Mapping[str, Any]] = None, threads: int = 0) -> None:
        texts = [f"{key}={json.dumps(value)}" for key, value in (changes or {}).items()]
        self._simulation = _meniscus.Simulation(scene, variant, texts, threads)

    @property
    def name(self) -> str:
        """Of the scene."""
        return self._simulation.name

    @property
    def duration(self) -> float:
        """Of the scene, s; steps may go on beyond."""
        return self._simulation.duration

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._simulation.dimension

    @property
    def size(self) -> int:
        """Number of particles, N."""
        return self._simulation.size

    @property
    def time(self) -> float:
        """Simulated, s."""
        return self._simulation.time

    @property
    def positions(self) -> NDArray:
        """(N, 3), m, in the order of ids, which stays the same; a new array each time."""
        return self._simulation.positions

    @property
    def velocities(self) -> NDArray:
        """(N, 3), m/s, likewise."""
        return self._simulation.velocities

    def step(self, longest: float = np.inf) -> StepReport:
        """One step, of at most so many seconds. Raises FailureError where the simulation diverges,
        then and ever after."""
        return StepReport(**self._simulation.step(longest))

    def run(self, until: float) -> None:
        """Steps up to that time (s), of which the last ends there. Raises as `step` does."""
        while self.time < until:
            self.step(until - self.time)

    def snapshot(self) -> Snapshot:
        """The state in the order of ids, with velocity, density, mass, pressure and, where the
        scene's surface is known, surface_class, normal and mean_curvature."""
        return Snapshot(**self._simulation.snapshot())
