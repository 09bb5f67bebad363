"""Random properties: values for settings that may be a number or a distribution.

Every draw lies within the range of the setting, and within ``rel_min`` below and ``rel_max`` above the mean if these are
given. Means, deviations and limits are in the unit of the setting.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

__all__ = ["Normal", "Uniform", "Triangular", "Beta", "Exponential", "Lognormal", "Gamma", "Empirical"]


@dataclass
class _Distribution:
    kind: ClassVar[str]
    mean: float
    std_dev: float | None = None
    rel_min: float | None = None
    rel_max: float | None = None

    def settings(self) -> dict[str, Any]:
        """As in a project file."""
        given = {"mean": self.mean, "distribution": self.kind, "std_dev": self.std_dev, "rel_min": self.rel_min,
                 "rel_max": self.rel_max}
        return {key: value for key, value in given.items() if value is not None}


class Normal(_Distribution):
    """A normal distribution with a mean and a standard deviation before truncation."""

    kind = "normal"


class Uniform(_Distribution):
    """All values between the limits are equally probable: from mean - rel_min to mean + rel_max."""

    kind = "uniform"


class Triangular(_Distribution):
    """A triangular distribution with its peak at the mean."""

    kind = "triangular"


class Beta(_Distribution):
    """A beta distribution between the limits."""

    kind = "beta"


class Exponential(_Distribution):
    """An exponential distribution; its standard deviation is its mean."""

    kind = "exponential"


class Lognormal(_Distribution):
    """A lognormal distribution with this mean and standard deviation of the values themselves."""

    kind = "lognormal"


class Gamma(_Distribution):
    """A gamma distribution with this mean and standard deviation."""

    kind = "gamma"


@dataclass
class Empirical:
    """Values of a table: every draw is one of them.

    ``file`` is relative to the project; ``column`` is the key of the property unless given; ``weight_column`` has weights
    of any sum.
    """

    file: str
    column: str | None = None
    weight_column: str | None = None

    def settings(self) -> dict[str, Any]:
        """As in a project file."""
        given = {"distribution": "empirical", "file": self.file, "column": self.column, "weight_column": self.weight_column}
        return {key: value for key, value in given.items() if value is not None}
