"""Tables as frames of pandas."""

from __future__ import annotations

import numpy as np
import pandas


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
