"""Shapes of rocks: the table ``[[shape]]`` of a project, made from what is known of a block."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Mapping

from . import settings as _settings

__all__ = ["Shape"]


class Shape(_settings.Shape):
    """[[shape]]: a shape of rocks, for ``Project(shape=[...])``; a seeder names it (``Seeder(shape="block")``).

    The class methods make the usual ones; all keys of the table can be given to the class itself, by name. Words such as
    ``"equant"`` or ``"cube"`` need no shape (docs/shapes.md).
    """

    @classmethod
    def ellipsoid(cls, a: float, b: float, c: float, *, name: str = "block", **settings: Any) -> Shape:
        """A rounded block with these axes [m], in any order. Only their ratios count: the size is the seeder's."""
        return cls(name=name, axes_m=[a, b, c], **settings)

    @classmethod
    def box(cls, a: float, b: float, c: float, *, name: str = "block") -> Shape:
        """A box with these edges [m], in any order. Only their ratios count: the size is the seeder's."""
        return cls(name=name, axes_m=[a, b, c], style="box")

    @classmethod
    def ratios(cls, b_over_a: Any, c_over_b: Any, *, name: str = "block", **settings: Any) -> Shape:
        """Blocks with these ratios of the axes a >= b >= c: numbers or distributions, drawn for each rock."""
        return cls(name=name, b_over_a=b_over_a, c_over_b=c_over_b, **settings)

    @classmethod
    def prism(cls, sides: int, *, length_ratio: float | None = None, name: str = "block") -> Shape:
        """A prism over a regular polygon; in 2D the polygon. ``length_ratio``: its length over the root of the area."""
        return cls(name=name, sides=sides, length_ratio=length_ratio)

    @classmethod
    def scan(cls, file: _settings.File, *, name: str = "block", corners: int | None = None) -> Shape:  # type: ignore[override]
        """The convex hull of a scan, a mesh (OBJ, STL, PLY) or points, in any unit; relative to the project's folder."""
        return cls(name=name, scan=Path(file).as_posix(), corners=corners)

    @classmethod
    def group(cls, shares: Mapping[str, float], *, name: str = "group") -> Shape:
        """One of other shapes is drawn for each rock: their names and shares."""
        return cls(name=name, of=list(shares), shares=list(shares.values()))
