"""Maps of a run in 3D."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _talus
from .problems import BadInput, path_text

if TYPE_CHECKING:
    import xarray

__all__ = ["Map", "MapClass"]


class MapClass(NamedTuple):
    """A class of the values of a map, of the same limits and colour in every run."""

    low: float
    high: float
    """Not in it; infinite: it has no limit."""
    colour: str
    """``#rrggbb``."""


class Map(np.ma.MaskedArray):
    """A map as a masked array: rows from north to south, columns from west to east. Cells without a rock are masked.

    Its attributes stay with results of the same shape; a part of it, or a flipped one, has no transform.
    """

    name: str
    """With its unit, as in the name of its file."""
    unit: str
    """Empty: none."""
    meaning: str
    transform: tuple[float, float, float, float, float, float]
    """The affine transformation from (column, row) to (x, y): a, b, c, d, e, f in the order of rasterio, so that
    ``rasterio.Affine(*transform)`` is the same. x = a column + b row + c, y = d column + e row + f [m], from the
    north-western corner of the map."""
    crs_wkt: str
    """The coordinate system as WKT; empty if it is unknown."""
    limits: tuple[float, ...]
    """Between its classes."""

    _facts = ("name", "unit", "meaning", "transform", "crs_wkt", "limits")

    @classmethod
    def _of(cls, name: str, found: tuple[Any, ...], crs_wkt: str) -> Map:
        values, (west, north), (dx, dy), unit, meaning, is_count, limits = found
        mask = np.isnan(values)
        if is_count:
            values = np.where(mask, 0, values).astype(np.int64)
        made = cls(values, mask=mask)
        made._optinfo.update(name=name, unit=unit, meaning=meaning, transform=(dx, 0.0, west, 0.0, -dy, north),
                             crs_wkt=crs_wkt, limits=tuple(limits))
        return made

    def _update_from(self, other: Any) -> None:  # called for all results and parts
        super()._update_from(other)
        if isinstance(other, Map) and (other.shape, other.strides) != (self.shape, self.strides):
            self._optinfo = {key: value for key, value in self._optinfo.items() if key != "transform"}
            self.__dict__.pop("transform", None)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (np.array(self.data), np.array(self.mask), dict(self._optinfo))

    def __getattr__(self, key: str) -> Any:
        if key in Map._facts:
            return self._optinfo.get(key)
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {key!r}")

    def _place(self) -> tuple[float, float, float, float, float, float]:
        if self.transform is None:
            raise BadInput("a part of a map, or a flipped one, has no transform")
        return self.transform

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """West, east, south, north [m], as matplotlib's imshow takes it."""
        a, _, west, _, e, north = self._place()
        rows, columns = self.shape
        return west, west + a * columns, north + e * rows, north

    @property
    def crs(self) -> str | None:
        """The coordinate system as rasterio, pyproj and others take it: ``"EPSG:25832"``, or WKT if it has no number; None
        if it is unknown."""
        return _talus.crs_name(self.crs_wkt) or None

    @property
    def classes(self) -> list[MapClass]:
        """Its classes: those of the maps of ``talus run`` in QGIS, in the workbench and in the report."""
        return [MapClass(low, high, "#{:02x}{:02x}{:02x}".format(*colour))
                for low, high, colour in _talus.map_classes(self.limits)]

    def to_geotiff(self, file: str | os.PathLike[str]) -> None:
        """Writes it as a GeoTIFF with its coordinate system, and its classes as a style for QGIS (.qml) beside it.

        As a run writes its maps: cells without a rock have no data; whole numbers stay whole. Raises
        :class:`talus.BadInput`.
        """
        path = path_text(file)
        if not path.lower().endswith((".tif", ".tiff")):
            raise BadInput(f"{path}: a map is written as a GeoTIFF (expected a name that ends with .tif)")
        a, _, west, _, e, north = self._place()
        values = self.astype(np.float64).filled(np.nan)
        _talus.write_map(path, self.name, self.unit, self.meaning, self.dtype.kind in "iu", self.limits, values,
                         (west, north), (a, -e), self.crs_wkt)

    def to_xarray(self) -> xarray.DataArray:
        """With coordinates x and y of the middles of cells; cells without a rock are NaN."""
        import xarray

        a, _, west, _, e, north = self._place()
        rows, columns = self.shape
        return xarray.DataArray(
            self.astype(np.float64).filled(np.nan),
            dims=("y", "x"),
            coords={"x": west + a * (np.arange(columns) + 0.5), "y": north + e * (np.arange(rows) + 0.5)},
            name=self.name,
            attrs={"units": self.unit, "long_name": self.meaning, "crs_wkt": self.crs_wkt,
                   "transform": self.transform},
        )


def _restored(values: np.ndarray, mask: np.ndarray, facts: dict[str, Any]) -> Map:
    made = Map(values, mask=mask)
    made._optinfo.update(facts)
    return made
