"""Maps of a run in 3D."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray

__all__ = ["Map"]


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
    """The affine transformation from (column, row) to (x, y), in the order of rasterio: x = a column + b row + c,
    y = d column + e row + f [m]."""
    crs_wkt: str
    """The coordinate system; empty if it is unknown."""

    _facts = ("name", "unit", "meaning", "transform", "crs_wkt")

    @classmethod
    def _of(cls, name: str, found: tuple[Any, ...], crs_wkt: str) -> Map:
        values, (west, north), (dx, dy), unit, meaning, is_count = found
        mask = np.isnan(values)
        if is_count:
            values = np.where(mask, 0, values).astype(np.int64)
        made = cls(values, mask=mask)
        made._optinfo.update(name=name, unit=unit, meaning=meaning, transform=(dx, 0.0, west, 0.0, -dy, north),
                             crs_wkt=crs_wkt)
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
            raise ValueError("a part of a map, or a flipped one, has no transform")
        return self.transform

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """West, east, south, north [m], as matplotlib's imshow takes it."""
        a, _, west, _, e, north = self._place()
        rows, columns = self.shape
        return west, west + a * columns, north + e * rows, north

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
