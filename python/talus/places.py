"""Lines and polygons on plan, as a user has them."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from . import _talus
from .problems import BadInput, path_text, unicode_text
from .shapes import numbers


def place_of(line: Any, polygon: Any, barrier: str | None) -> Any:
    """The one that is given, for the engine."""
    given = {"line": line, "polygon": polygon, "barrier": barrier}
    named = [name for name, each in given.items() if each is not None]
    if len(named) != 1:
        what = f"{', '.join(named)} are given" if named else "nothing is asked for"
        raise BadInput(f"{what} (expected one of line, polygon and barrier)")
    kind = named[0]
    if kind == "barrier":
        return _talus.GivenPlace(_talus.PlaceKind.barrier, unicode_text("barrier", barrier))
    return _talus.GivenPlace(getattr(_talus.PlaceKind, kind), _corners(kind, given[kind]))


def _corners(name: str, given: Any) -> str | list[list[float]]:
    if isinstance(given, os.PathLike):
        return path_text(given)
    if isinstance(given, str):
        return unicode_text(name, given)
    shape = getattr(given, "__geo_interface__", None)
    if shape is not None:
        given = _of_geometry(name, shape)
    array = numbers(name, given)
    if name == "line" and array.ndim == 0:  # a place of a section
        array = np.array([[array.item(), 0.0]])
    if array.ndim != 2 or array.shape[1] != 2:
        raise BadInput(f"{name} has the shape {array.shape} (expected (n, 2): x and y of its corners; a geometry of "
                       "shapely; or the path of a GIS file)")
    return array.tolist()


def _of_geometry(name: str, shape: dict[str, Any]) -> list[Any]:
    """The corners of a geometry as shapely and others have it."""
    wanted = {"line": "LineString", "polygon": "Polygon"}[name]
    if shape.get("type") != wanted:
        raise BadInput(f"{name} is a {shape.get('type')} (expected a {wanted})")
    corners = shape["coordinates"]
    if wanted == "Polygon":
        if len(corners) > 1:
            raise BadInput("polygon has holes (only polygons without holes can be asked for)")
        corners = corners[0][:-1]
    return [corner[:2] for corner in corners]
