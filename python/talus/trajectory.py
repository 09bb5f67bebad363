"""One rock's trajectory."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from .shapes import check, numbers

__all__ = ["Motion", "Trajectory"]


class Motion(NamedTuple):
    """The motion of a rock's centre, in the project's coordinates."""

    position: np.ndarray
    """[m], shape (3,) or (n, 3)"""
    velocity: np.ndarray
    """[m/s]"""
    spin: np.ndarray
    """[rad/s]"""


class Trajectory:
    """The trajectory of one rock, the same as in a run."""

    def __init__(self, core: Any) -> None:
        self._core = core

    @property
    def rock(self) -> int:
        """Its number in the run, from 0."""
        return self._core.rock

    @property
    def seeder(self) -> str:
        """The name of its seeder."""
        return self._core.seeder

    @property
    def mass(self) -> float:
        """[kg]"""
        return self._core.mass

    @property
    def radius(self) -> float:
        """Of the equivalent sphere [m]."""
        return self._core.radius

    @property
    def duration(self) -> float:
        """From release to end [s]."""
        return self._core.duration

    @property
    def end_reason(self) -> str:
        """Why it ended."""
        return self._core.end_reason

    @property
    def events(self) -> np.ndarray:
        """Release, arrival and departure at every contact, end: the columns of paths.csv."""
        return self._core.events()

    def at(self, time: Any) -> Motion:
        """Its motion at times [s] since the release, a number or an array; before and after: at its release and end."""
        times = numbers("time", time)
        check("time", times, -np.inf)
        return Motion(*(each.reshape(times.shape + (3,)) for each in self._core.at(times.reshape(-1))))

    def __repr__(self) -> str:
        return f"<talus.Trajectory of rock {self.rock}: {self.duration:.2f} s, {self.end_reason}>"
