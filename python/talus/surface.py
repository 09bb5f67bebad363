"""The terrain of a model."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _talus
from .flight import standard_gravity
from .problems import BadInput
from .shapes import check, number, numbers, together, vectors

__all__ = ["Bounds", "Contact", "Section", "Surface"]


class Bounds(NamedTuple):
    """[m]"""

    west: float
    east: float
    south: float
    north: float
    lowest: float
    highest: float


class Contact(NamedTuple):
    """First contacts of flights with the ground; NaN, and a facet of -1, where there is none."""

    time: np.ndarray
    """From the start of the flight [s]."""
    position: np.ndarray
    """Of the rock's centre [m], shape (3,) or (n, 3)."""
    normal: np.ndarray
    """Unit, out of the ground; at an edge or a vertex from there to the rock's centre."""
    facet: np.ndarray
    """Number of the segment, triangle or cell, from 0."""


class Section(NamedTuple):
    """The ground along a line: a vertex where it bends."""

    distance: np.ndarray
    """Along the line, on plan [m], shape (n,)."""
    position: np.ndarray
    """On the ground [m], shape (n, 3)."""

    @property
    def vertices(self) -> np.ndarray:
        """[x, z] of each vertex [m], shape (n, 2): a section for ``talus.Terrain(section=...)``."""
        return np.column_stack([self.distance, self.position[:, 2]])


class Surface:
    """A section, a mesh or a raster. Coordinates are those of the project; in a section y is 0."""

    def __init__(self, model: Any) -> None:
        self._core = model

    @property
    def bounds(self) -> Bounds:
        """The box around it."""
        return Bounds(*_talus.bounds(self._core))

    def elevation(self, x: Any, y: Any = 0) -> Any:
        """The highest ground [m] at places on plan, numbers or arrays; NaN where there is none."""
        shape, flat = together(x=numbers("x", x), y=numbers("y", y))
        found = _talus.elevation(self._core, flat["x"], flat["y"]).reshape(shape)
        return found if shape else float(found)

    def first_contact(self, position: Any, velocity: Any, *, radius: Any = 0, gravity: float = standard_gravity,
                      longest: float = 1000) -> Contact:
        """Where flights first touch the ground.

        Positions [m] and velocities [m/s] have the shape (3,) or (n, 3). ``radius`` [m]: 0: a point. ``longest``: flights
        are followed for this time [s].
        """
        shape, flat = together(position_3=vectors("position", position), velocity_3=vectors("velocity", velocity),
                               radius=numbers("radius", radius))
        check("radius", flat["radius"], 0, 1e4)
        time, place, normal, facet = _talus.first_contact(
            self._core, *flat.values(), number("gravity", gravity, 0, 1000), number("longest", longest, 0, 1e6))
        return Contact(time.reshape(shape), place.reshape(shape + (3,)), normal.reshape(shape + (3,)),
                       facet.astype(np.int64).reshape(shape))

    def section(self, line: Any, *, tolerance: Any = 0) -> Section:
        """The ground along a line on plan.

        ``line``: its corners [m], shape (n, 2). ``tolerance`` [m]: vertices within this distance of the line through
        the others are left out (Douglas-Peucker). ``BadInput``: the terrain is itself a section, or the line has no
        length or leaves the ground.
        """
        corners = numbers("line", line)
        if corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 2:
            raise BadInput(f"line has the shape {corners.shape} (expected (n, 2): x and y of two or more corners)")
        check("line", corners, -1e9, 1e9)
        return Section(*_talus.section(self._core, corners[:, 0], corners[:, 1], number("tolerance", tolerance, 0, 1e9)))
