"""Figures with what is known of them."""

from __future__ import annotations

from math import isfinite, nan
from typing import NamedTuple, Sequence

__all__ = ["Estimate"]


class Estimate(NamedTuple):
    """A figure and its confidence interval; NaN: unknown, an end of an interval for want of rocks."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        if not isfinite(self.value):
            return "unknown"
        return f"{self.value:.3g} ({_end(self.low)} to {_end(self.high)})"

    @classmethod
    def _of(cls, given: Sequence[float | None] | None, unit: float = 1) -> Estimate:
        """Of a value and its ends in JSON."""
        if given is None:
            return cls(nan, nan, nan)
        return cls(*(nan if number is None else number / unit for number in given))

    @classmethod
    def _of_share(cls, given: dict[str, float] | None) -> Estimate:
        return cls._of(None if given is None else [given["value"], given["low"], given["high"]])


def _end(number: float) -> str:
    return f"{number:.3g}" if isfinite(number) else "unknown"
