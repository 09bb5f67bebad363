"""The terrain of a model."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _talus
from .flight import standard_gravity
from .shapes import check, numbers, together, vectors

__all__ = ["Bounds", "Contact", "Surface"]


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
        check("gravity", numbers("gravity", gravity), 0, 1000)
        check("longest", numbers("longest", longest), 0, 1e6)
        time, place, normal, facet = _talus.first_contact(self._core, *flat.values(), float(gravity), float(longest))
        return Contact(time.reshape(shape), place.reshape(shape + (3,)), normal.reshape(shape + (3,)),
                       facet.astype(np.int64).reshape(shape))
