"""What a run says about a line, a polygon or a ditch."""

from __future__ import annotations

from html import escape
import json
from math import nan
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .estimates import Estimate
from .problems import Problem

if TYPE_CHECKING:
    import pandas

__all__ = ["DitchAnswer", "Ensembles", "Kit", "KitAnswer", "LineAnswer", "PolygonAnswer"]

_quantities = (("energy", "kJ", 1000), ("height", "m", 1), ("velocity", "m_s", 1))


class Kit(NamedTuple):
    """A barrier kit."""

    kit_class: int | None
    """Of its energy, by EAD 340059-00-0106; None: it is in none."""
    energy_kJ: float
    height_m: float

    @classmethod
    def _of(cls, given: dict[str, Any] | None) -> Kit | None:
        return given and cls(given["class"], given["energy_J"] / 1000, given["height_m"])


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


class Ensembles(NamedTuple):
    """How far the figures differ between the ensembles of a run with uncertain parameters: of each the value of all rocks,
    and the range in which most ensembles are. It contains the chance of their rocks. NaN: too few ensembles."""

    ensembles: int
    """Ensembles with rocks that were asked."""
    crossing: int
    """Of these, with rocks that cross or enter."""
    confidence: float
    """The share of the ensembles that is in the ranges."""
    share: Estimate
    """Of the rocks that cross or enter."""
    stopping_share: Estimate
    """Of the rocks that stop in a polygon."""
    energy_translational_kJ: Estimate
    energy_total_kJ: Estimate
    height_m: Estimate
    velocity_m_s: Estimate
    needs_energy_kJ: Estimate
    """Of the fence that the check asks for at a line."""
    needs_height_m: Estimate

    @classmethod
    def _of(cls, given: dict[str, Any] | None) -> Ensembles | None:
        if given is None:
            return None

        def of(key: str, unit: float = 1) -> Estimate:
            return Estimate._of(given.get(key), unit)

        return cls(given["ensembles"], given["crossing"], given["confidence"], of("share"), of("stopping"),
                   of("ke_translational_J", 1000), of("ke_total_J", 1000), of("height_m"), of("velocity_m_s"),
                   of("needs_energy_J", 1000), of("needs_height_m"))


class _Answer:
    """What all answers have."""

    json: dict[str, Any]
    """Everything, with the keys of the workbench's API."""

    def __init__(self, asked: Any, found: tuple[str, np.ndarray, list[Problem]]) -> None:
        text, self._rocks, self._warnings = found
        self.json = json.loads(text)
        self._asked = asked

    @property
    def rocks(self) -> int:
        """Rocks whose trajectories were asked: all, or those that the run kept, a fair sample."""
        return self.json["run"]["stored"]

    @property
    def confidence(self) -> float:
        """Of all intervals, which are those of chance alone."""
        return self.json["confidence"]

    @property
    def warnings(self) -> list[Problem]:
        """Why the answer should not be trusted as it is."""
        return self._warnings

    @property
    def sources(self) -> np.ndarray:
        """A row for each place of release from which rocks come: where it is, its rocks, and those that cross or enter."""
        found = self.json["sources"]
        names, places = self._asked.sources()
        release = np.array(found["release"], dtype=np.int64)
        counts = [key for key in ("rocks", "crossing", "clearing", "stopping") if key in found]
        rows = np.empty(len(release), dtype=[
            ("place", "i8"), ("source", f"U{max(map(len, names), default=1) or 1}"), ("x_m", "f8"), ("y_m", "f8"),
            *((key, "i8") for key in counts), ("share", "f8"), ("share_low", "f8"), ("share_high", "f8")])
        rows["place"], rows["source"] = release, [names[k] for k in release]
        rows["x_m"], rows["y_m"] = places[release, 0], places[release, 1]
        for key in counts:
            rows[key] = found[key]
        for column, key in (("share", "share"), ("share_low", "low"), ("share_high", "high")):
            rows[column] = found[key]
        return rows

    def _table(self) -> list[tuple[str, str]]:
        raise NotImplementedError

    def __repr__(self) -> str:
        text = "; ".join(f"{label}: {value}" for label, value in self._table())
        return f"<talus.{type(self).__name__}: {text}>"

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{escape(label)}</td><td>{escape(value)}</td></tr>" for label, value in self._table())
        doubts = "".join(f"<p>{escape(str(problem))}</p>" for problem in self.warnings)
        return f"<table>{rows}</table>{doubts}"


class LineAnswer(_Answer):
    """Which rocks cross a line, and how fast, high and strong they are there.

    Energy, height and velocity are those below which the design percentile of the crossing rocks are. The height is that
    of the block's top above the foot of the line.
    """

    @property
    def name(self) -> str:
        """Of the barrier or collector; empty: a line."""
        return self.json["name"] if self.json["kind"] != "line" else ""

    @property
    def length_m(self) -> float:
        """On plan; of a place of a section 0."""
        return self.json["length_m"]

    @property
    def foot(self) -> np.ndarray:
        """Its corners on the ground [m], shape (n, 3)."""
        return np.array(self.json["foot"], dtype=float).reshape(-1, 3)

    @property
    def crossing(self) -> int:
        """The number of rocks that cross."""
        return self.json["whole"]["rocks"]

    @property
    def crossing_rocks(self) -> np.ndarray:
        """Their numbers, ascending."""
        return self._rocks

    @property
    def share(self) -> Estimate:
        """Of the rocks asked."""
        return Estimate._of_share(self.json["whole"]["share"])

    @property
    def percentile(self) -> float:
        """The design percentile [%]."""
        return self.json["design_percentile"]

    @property
    def energy_kind(self) -> str:
        """``"translational"`` or ``"total"``: which energy the check takes."""
        return "total" if self.json["factors"]["of_total_energy"] else "translational"

    @property
    def energy_kJ(self) -> Estimate:
        """The energy that the check takes."""
        return Estimate._of(self.json["design"]["energy_J"], 1000)

    @property
    def height_m(self) -> Estimate:
        """Of the block's top above the foot."""
        return Estimate._of(self.json["design"]["height_m"])

    @property
    def velocity_m_s(self) -> Estimate:
        """The velocity."""
        return Estimate._of(self.json["design"]["velocity_m_s"])

    @property
    def standard(self) -> str:
        """Whose factors are applied; empty: none."""
        return self.json["standard"] or ""

    @property
    def needs(self) -> Kit | None:
        """The kit that the standard asks for; None: no rock crosses."""
        return Kit._of(self.json["whole"]["needs"])

    @property
    def kit(self) -> KitAnswer | None:
        """What the kit that was given would stop."""
        found = self.json["kit"]
        return found and KitAnswer(Kit(found["class"], found["energy_kJ"], found["height_m"]), found["stopped"],
                                   Estimate._of_share(found["share"]), found["above"], found["through"])

    @property
    def ensembles(self) -> Ensembles | None:
        """The range between the ensembles of the run; None: all rocks have the same parameters."""
        return Ensembles._of(self.json["ensembles"])

    @property
    def rocks_needed(self) -> int | None:
        """How many rocks would bring every interval within 10 % of its value; None: unknown."""
        return self.json["enough"]["rocks"]

    @property
    def profile(self) -> np.ndarray:
        """A row for each stretch of the line: rocks that cross there, and the figures with their intervals."""
        figures = [(f"{name}{end}_{unit}", "f8") for name, unit, _ in _quantities for end in ("", "_low", "_high")]
        rows = np.full(len(self.json["sections"]), nan, dtype=[("from_m", "f8"), ("to_m", "f8"), ("rocks", "f8"), *figures])
        percentile = f"{self.percentile:.15g}"
        keys = {"energy": f"ke_{self.energy_kind}_J", "height": "height_m", "velocity": "velocity_m_s"}
        for row, section in zip(rows, self.json["sections"]):
            row["from_m"], row["to_m"], row["rocks"] = section["from_m"], section["to_m"], section["rocks"]
            for name, unit, per in _quantities:
                found = Estimate._of(section["percentiles"][keys[name]].get(percentile), per)
                for end, number in zip(("", "_low", "_high"), found):
                    row[f"{name}{end}_{unit}"] = number
        kinds = [(name, "i8" if name == "rocks" else "f8") for name in rows.dtype.names]
        return rows.astype(kinds)

    def to_pandas(self) -> pandas.DataFrame:
        """The profile as a frame."""
        from .frames import frame_of

        return frame_of(self.profile)

    def _table(self) -> list[tuple[str, str]]:
        card, rocks = self.json["card"], f"{self.crossing} of {self.rocks} rocks cross"
        if card["share"]:
            rocks += f", {card['share']} ({card['share_interval']})"
        rows = [("line" if not self.name else self.name, rocks)]
        if self.crossing:
            below = f"{self.percentile:g} % have at most"
            energy = f"{card['energy']} ({card['energy_interval']}), {self.energy_kind}"
            rows += [(below, energy), ("height", f"{card['height']} ({card['height_interval']})"),
                     ("velocity", f"{card['velocity']} ({card['velocity_interval']})")]
            if self.standard:
                rows.append((self.standard, card["needs"] or "no kit is enough"))
            if self.json["kit"]:
                rows.append(("kit", self.json["kit"]["text"]))
        return rows


class PolygonAnswer(_Answer):
    """Which rocks enter a polygon, which stop in it, and the maxima of each inside.

    The height is the bounce height of the block's lowest point above the ground.
    """

    @property
    def area_m2(self) -> float:
        """On plan."""
        return self.json["area_m2"]

    @property
    def outline(self) -> np.ndarray:
        """Its corners on the ground [m], shape (n, 3); z is NaN off the terrain."""
        return np.array(self.json["outline"], dtype=float).reshape(-1, 3)

    @property
    def entering(self) -> int:
        """The number of rocks that are inside at any time."""
        return self.json["entering"]["rocks"]

    @property
    def entering_rocks(self) -> np.ndarray:
        """Their numbers, ascending."""
        return self._rocks

    @property
    def entering_share(self) -> Estimate:
        """Of the rocks asked."""
        return Estimate._of_share(self.json["entering"]["share"])

    @property
    def stopping(self) -> int:
        """The number of rocks whose path ends inside."""
        return self.json["stopping"]["rocks"]

    @property
    def stopping_share(self) -> Estimate:
        """Of the rocks asked."""
        return Estimate._of_share(self.json["stopping"]["share"])

    @property
    def ensembles(self) -> Ensembles | None:
        """The range between the ensembles of the run; None: all rocks have the same parameters."""
        return Ensembles._of(self.json["ensembles"])

    def percentile(self, quantity: str, percentile: float) -> Estimate:
        """Of the maxima of the rocks inside: of ``"ke_total_J"``, ``"ke_translational_J"``, ``"velocity_m_s"`` or
        ``"height_m"``, for the percentiles of the project's design (50, 95 and 99 unless it says otherwise). NaN: there
        is none."""
        return Estimate._of(self.json["percentiles"].get(quantity, {}).get(f"{percentile:.15g}"))

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each quantity and percentile, with its interval."""
        import pandas

        rows = [(quantity, float(percentile), *Estimate._of(found))
                for quantity, of in self.json["percentiles"].items() for percentile, found in of.items()]
        return pandas.DataFrame(rows, columns=["quantity", "percentile", "value", "low", "high"])

    def _table(self) -> list[tuple[str, str]]:
        return [("enter", _count(self.entering, self.rocks, self.entering_share)),
                ("stop inside", _count(self.stopping, self.rocks, self.stopping_share))]


class DitchAnswer(_Answer):
    """What rocks do between the toe and the far edge of a ditch in a section."""

    @property
    def arriving(self) -> int:
        """The number of rocks that get past the toe."""
        return self.json["arriving"]["rocks"]

    @property
    def inside(self) -> int:
        """The number of rocks that end inside."""
        return self.json["inside"]["rocks"]

    @property
    def beyond(self) -> int:
        """The number of rocks that get beyond the far edge."""
        return self.json["beyond"]["rocks"]

    @property
    def retained(self) -> Estimate:
        """The share of those that get past the toe which are retained."""
        return Estimate._of_share(self.json["retained"]["share"])

    def _table(self) -> list[tuple[str, str]]:
        return [("past the toe", f"{self.arriving} of {self.json['rocks']} rocks"), ("end inside", f"{self.inside}"),
                ("beyond the far edge", f"{self.beyond}"), ("retained", _percents(self.retained))]


def _percents(share: Estimate) -> str:
    if share.value != share.value:
        return "unknown"
    return f"{100 * share.value:.1f} % ({100 * share.low:.1f} to {100 * share.high:.1f} %)"


def _count(count: int, rocks: int, share: Estimate) -> str:
    return f"{count} of {rocks} rocks" + (f", {_percents(share)}" if share.value == share.value else "")
