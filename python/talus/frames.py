"""Tables as frames of pandas."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas

from .problems import BadInput
from .spoken import meant


def chosen_frame(of: Any, table: str, known: tuple[str, ...]) -> pandas.DataFrame:
    """The frame of one of the tables that a result has."""
    if table not in known:
        raise BadInput(f"there is no table {table!r} (expected {', '.join(known)}){meant(table, known)}")
    found = getattr(of, table)
    return found if isinstance(found, pandas.DataFrame) else frame_of(found)


def frame_of(table: np.ndarray) -> pandas.DataFrame:
    """Words become categories, and whole numbers that may be empty become the type Int64."""
    return pandas.DataFrame({name: _column(table[name]) for name in table.dtype.names})


def _column(values: np.ndarray) -> object:
    if values.dtype.kind == "U":
        places, words = pandas.factorize(values.astype(object), sort=True)
        return pandas.Categorical.from_codes(places, words)
    if values.dtype.kind == "i":
        return pandas.arrays.IntegerArray(values.copy(), values < 0)
    return values
