"""Flight: a parabola, or with linear drag as in a forest. Equations and sources are in docs/laws.md."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _talus
from .shapes import check, number, numbers, together, vectors

__all__ = ["State", "at", "standard_gravity"]

standard_gravity = 9.80665
"""[m/s2]"""


class State(NamedTuple):
    """Where a rock in flight is, and how fast."""

    position: np.ndarray
    """[m], shape (3,) or (n, 3)"""
    velocity: np.ndarray
    """[m/s], shape (3,) or (n, 3)"""


def at(position: Any, velocity: Any, time: Any, *, gravity: float = standard_gravity, drag_rate: float = 0) -> State:
    """The state at ``time`` [s] of a flight that begins at ``position`` [m] with ``velocity`` [m/s].

    Positions and velocities have the shape (3,) or (n, 3), times are a number or an array of n. ``drag_rate``: the drag
    of a forest over the rock's mass, b/m [1/s]; 0: none. Coordinates, speeds, times and rates reach up to 1e9, gravity up
    to 1000 m/s2, as in a project.
    """
    shape, flat = together(position_3=vectors("position", position), velocity_3=vectors("velocity", velocity),
                           time=numbers("time", time))
    for name in ("position", "velocity"):
        check(name, flat[f"{name}_3"], -1e9, 1e9)
    check("time", flat["time"], 0, 1e9)
    positions, velocities = _talus.flight_at(*flat.values(), number("gravity", gravity, 0, 1000),
                                             number("drag_rate", drag_rate, 0, 1e9))
    return State(positions.reshape(shape + (3,)), velocities.reshape(shape + (3,)))
