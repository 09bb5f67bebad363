"""Figures as texts, in the words of the workbench's cards. A figure is known by its name, which ends with its unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, floor, isfinite, log10
from typing import Any

from .estimates import Estimate

_units = {"_kJ": "kJ", "_m_s": "m/s", "_m": "m", "_class": ""}


def model_name(model: str) -> str:
    """``"rigid sphere"`` of ``"rigid_sphere"``."""
    return model.replace("_", " ")


def unit_of(figure: str) -> str:
    """``"kJ"`` of ``"energy_kJ"``; of shares ``"%"``, of classes nothing."""
    return next((unit for ending, unit in _units.items() if figure.endswith(ending)), "%")


def number_text(value: float, most_decimals: int = 9) -> str:
    """With three significant digits and thousands separators; whole numbers have all digits. However few decimals there
    may be, there is one digit."""
    if not isfinite(value):
        return "unknown"
    if value == 0 or abs(value) < 1e-6:
        return "0"
    first = -floor(log10(abs(value)))
    decimals = 0 if value == round(value) else max(min(2 + first, max(most_decimals, first)), 0)
    text = f"{value:,.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def percent_text(share: float) -> str:
    """Close to 0 and 100 % with as many decimals as it takes to differ from them."""
    gap = min(100 * share, 100 - 100 * share)
    decimals = 0 if gap <= 0 else 1 if gap >= 0.1 else min(6, ceil(-log10(gap)) + 1)
    # Halves are rounded up, as in the workbench; 1e-9: those of shares of rocks are seldom exact numbers.
    text = f"{floor(100 * share * 10**decimals + 0.5 + 1e-9) / 10**decimals:.{decimals}f}"
    return f"{text.rstrip('0').rstrip('.') if '.' in text else text} %"


def value_text(figure: str, value: float) -> str:
    """``"204 kJ"``; ``"none"``: no rock crosses."""
    if not isfinite(value):
        return "none"
    unit = unit_of(figure)
    return percent_text(value) if unit == "%" else f"{number_text(value)} {unit}".rstrip()


def range_text(figure: str, low: float, high: float) -> str:
    """``"186 to 232 kJ"``; ``"186 kJ or more"`` with too few rocks for an upper end."""
    if isfinite(low) and isfinite(high):
        unit = unit_of(figure)
        return f"{value_text(figure, low).removesuffix(f' {unit}')} to {value_text(figure, high)}"
    if isfinite(low):
        return f"{value_text(figure, low)} or more"
    return f"up to {value_text(figure, high)}" if isfinite(high) else "too few rocks"


def spread_text(figure: str, low: float, high: float) -> str:
    """``"47.8 to 143 kJ"``; ``"100 % in each"`` of the sets."""
    least, most = value_text(figure, low), value_text(figure, high)
    return f"{least} in each" if least == most else range_text(figure, low, high)


def sampling_text(figure: str, of: Estimate) -> str:
    """The interval of a figure; of no rock there is none."""
    return range_text(figure, of.low, of.high) if isfinite(of.value) else "–"


def estimate_text(figure: str, of: Estimate) -> str:
    """``"204 kJ (186 to 232 kJ)"``"""
    return f"{value_text(figure, of.value)} ({sampling_text(figure, of)})" if isfinite(of.value) else "none"


def change_text(figure: str, of: Estimate) -> str:
    """``"+4.2 (+3.6 to +4.8) kJ"``; that of a share is in points."""
    if not isfinite(of.value):
        return "none crosses"
    unit = unit_of(figure)
    value, low, high = (signed_text(100 * each if unit == "%" else each) for each in of)
    unit = "% points" if unit == "%" else unit
    return f"{value} ({low} to {high}) {unit}" if isfinite(of.low) and isfinite(of.high) else f"{value} {unit}"


def signed_text(value: float) -> str:
    """``"+4.2"``"""
    text = number_text(value, 3)
    return f"+{text}" if value > 0 and text != "0" else text


def count_text(count: int, one: str) -> str:
    """``"1,234 rocks"``"""
    return f"{count:,} {one}{'' if count == 1 else 's'}"


def titles_of(percentile: float, place: str, is_area: bool = False) -> dict[str, str]:
    """What the figures of an answer are called. ``place``: ``"the line"``, or the name of a barrier."""
    top = f"{percentile:g} %"
    return {"share": f"{'Enters' if is_area else 'Passes'} {place}",
            "stopping_share": f"Stops in {place}",
            "energy_translational_kJ": f"{top} energy there, translational",
            "energy_total_kJ": f"{top} energy there, total",
            "height_m": f"{top} bounce height" if is_area else f"{top} height of the block's top",
            "velocity_m_s": f"{top} velocity",
            "needs_class": "Fence needed, class",
            "needs_energy_kJ": "Fence needed, energy",
            "needs_height_m": "Fence needed, height",
            "runout_m": f"{top} runout",
            "left": "Leaves the model"}


def fence_note(standard: str, applied: Sequence[Mapping[str, Any]] = ()) -> str:
    """Whose factors a fence has, and those that are known to apply."""
    factors = ", ".join(f"{each['symbol']} {each['value']:g}" for each in applied if each["value"] != 1)
    return f"Fence: {standard}, with {factors or 'its factors'}." if standard else "Fence: no standard is chosen, no factors are applied."
