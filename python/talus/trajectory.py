"""One rock's trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .shapes import check, numbers

if TYPE_CHECKING:
    import pandas

__all__ = ["Block", "Motion", "Trajectory"]


class Motion(NamedTuple):
    """The motion of a rock's centre, in the project's coordinates."""

    position: np.ndarray
    """[m], shape (3,) or (n, 3)"""
    velocity: np.ndarray
    """[m/s]"""
    spin: np.ndarray
    """[rad/s]"""


class Block(NamedTuple):
    """A rock with a shape, in its own frame: its principal axes through its centre, the longest along x."""

    corners: np.ndarray
    """[m], shape (n, 3)"""
    triangles: np.ndarray
    """of its hull: numbers of corners, counter-clockwise from outside, shape (m, 3); none in 2D"""
    moments: np.ndarray
    """principal moments of inertia [kg m2], shape (3,)"""


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

    @property
    def block(self) -> Block | None:
        """The rock's shape; None of a sphere or a point."""
        parts = self._core.block()
        return None if parts is None else Block(*parts)

    @property
    def orientation(self) -> np.ndarray | None:
        """How the block is turned at the times of `events`: quaternions (w, x, y, z) from its own frame to the axes of the
        coordinates, shape (n, 4); None of a sphere or a point."""
        return self.orientation_at(self.events["time_s"])

    def orientation_at(self, time: Any) -> np.ndarray | None:
        """How the block is turned at times [s] since the release, a number or an array: as `orientation`."""
        times = numbers("time", time)
        check("time", times, -np.inf)
        turns = self._core.orientation_at(times.reshape(-1))
        return None if turns is None else turns.reshape(times.shape + (4,))

    def frame(self) -> pandas.DataFrame:
        """The events as a frame."""
        from .frames import frame_of

        return frame_of(self.events)

    def __repr__(self) -> str:
        return f"<talus.Trajectory of rock {self.rock}: {self.duration:.2f} s, {self.end_reason}>"
