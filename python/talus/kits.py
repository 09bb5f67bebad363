"""Barrier kits, and what they stop."""

from __future__ import annotations

from math import nan
from typing import Any, NamedTuple

from .estimates import Estimate
from .texts import count_text, value_text

__all__ = ["Kit", "KitAnswer", "Stretch"]


class Kit(NamedTuple):
    """A barrier kit."""

    kit_class: int | None
    """Of its energy, by EAD 340059-00-0106; None: it is in none."""
    energy_kJ: float
    height_m: float

    @classmethod
    def _of(cls, given: dict[str, Any] | None) -> Kit | None:
        return given and cls(given["class"], given["energy_J"] / 1000, given["height_m"])

    def __str__(self) -> str:
        kind = "in no class" if self.kit_class is None else f"class {self.kit_class}"
        return f"{kind}, {self._size}"

    @property
    def _size(self) -> str:
        return f"{value_text('energy_kJ', self.energy_kJ)}, {value_text('height_m', self.height_m)}"


class Stretch(NamedTuple):
    """A part of a line."""

    from_m: float
    """Along the line."""
    to_m: float
    rocks: int
    """That cross there."""
    needs: Kit | None
    """The kit that the standard asks for there."""

    def text(self, standard: str) -> str:
        """Where it is, what it needs by a standard or without, and how many rocks say so."""
        start, end = (value_text("height_m", each) for each in (self.from_m, self.to_m))
        return f"{start} to {end}, {fence_text(self.needs, standard)}, {count_text(self.rocks, 'rock')}"


class KitAnswer(NamedTuple):
    """What a kit on the line would stop."""

    kit: Kit
    stopped: int
    """Rocks of those that cross."""
    share: Estimate
    above: int
    """Rocks that cross above it."""
    through: int
    """Rocks that are low enough, but have too much energy."""


def fence_text(kit: Kit | None, standard: str) -> str:
    """Of a fence that is needed; its class is one by a standard."""
    return "none" if kit is None else str(kit) if standard else kit._size


def needed(kit: Kit | None, upper: Kit | None) -> dict[str, Estimate]:
    """What a fence needs, with the upper end of its interval."""
    def of(key: str) -> Estimate:
        return Estimate(*(nan if each is None else getattr(each, key) for each in (kit, None, upper)))

    return {"needs_class": of("kit_class"), "needs_energy_kJ": of("energy_kJ"), "needs_height_m": of("height_m")}
