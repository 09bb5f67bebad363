"""Shapes of arguments of vectorised functions."""

from __future__ import annotations

from typing import Any

import numpy as np

from .problems import BadInput


def numbers(name: str, value: Any) -> np.ndarray:
    try:
        array = np.asarray(value)
        if array.dtype.kind in "iuf" or array.size == 0:
            return array.astype(np.float64)
    except (TypeError, ValueError):  # lists of another length
        pass
    raise BadInput(f"{name}={_brief(value)}: expected a number or an array of numbers")


def _brief(value: Any, longest: int = 40) -> str:
    text = repr(value)
    return text if len(text) <= longest else f"{text[:longest]}..."


def number(name: str, value: Any, least: float, most: float) -> float:
    """One number."""
    array = numbers(name, value)
    if array.size != 1:
        raise BadInput(f"{name} has the shape {array.shape} (expected one number)")
    check(name, array, least, most)
    return array.item()


def vectors(name: str, value: Any) -> np.ndarray:
    array = numbers(name, value)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise BadInput(f"{name} has the shape {array.shape} (expected (3,) or (n, 3): x, y and z of each)")
    return array


def check(name: str, array: np.ndarray, least: float, most: float = np.inf) -> None:
    """Refuses NaN and numbers out of range."""
    good = (array >= least) & (array <= most)
    if good.all():
        return
    limits = f"at least {least:g}" + ("" if np.isinf(most) else f" and at most {most:g}")
    raise BadInput(f"{name}={array[~good].flat[0]:g}: expected {limits}")


def together(**arrays: np.ndarray) -> tuple[tuple[int, ...], dict[str, np.ndarray]]:
    """The common shape without the axis of vectors, and the arrays broadcast to it and flattened.

    Names that end with ``_3`` are vectors.
    """
    shapes = {name: array.shape[:-1] if name.endswith("_3") else array.shape for name, array in arrays.items()}
    try:
        shape = np.broadcast_shapes(*shapes.values())
    except ValueError:
        given = ", ".join(f"{name.removesuffix('_3')} {each}" for name, each in shapes.items())
        raise BadInput(f"the arrays have different lengths ({given})") from None
    flat = {}
    for name, array in arrays.items():
        full = shape + (3,) if name.endswith("_3") else shape
        flat[name] = np.broadcast_to(array, full).reshape((-1, 3) if name.endswith("_3") else (-1,))
    return shape, flat
