"""What a run says about a line, a polygon or a ditch."""

from __future__ import annotations

import json
from math import nan
from typing import TYPE_CHECKING, Any

import numpy as np

from .ensembles import Ensembles
from .estimates import Estimate
from .framed import Framed
from .kits import Kit, KitAnswer, Stretch, needed
from .problems import Problem
from .tables import Table
from .texts import count_text, fence_note, sampling_text, titles_of, value_text

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

__all__ = ["DitchAnswer", "LineAnswer", "PolygonAnswer"]

_quantities = (("energy", "kJ", 1000), ("height", "m", 1), ("velocity", "m_s", 1))


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

    def _shown(self) -> Table:
        raise NotImplementedError

    def __repr__(self) -> str:
        count = len(self.warnings)
        return self._shown().text + (f"\n{count_text(count, 'warning')}, in warnings" if count else "")

    def _repr_html_(self) -> str:
        table = self._shown()
        return table._replace(notes=[*table.notes, *map(str, self.warnings)]).html


class _PlaceAnswer(Framed, _Answer):
    """What answers about a line or a polygon have."""

    @property
    def ensembles(self) -> Ensembles | None:
        """The range between the ensembles of the run; None: all rocks have the same parameters."""
        return Ensembles._of(self.json.get("ensembles"), self._percentile())

    def _percentile(self) -> float:
        raise NotImplementedError

    def _cards(self, figures: dict[str, Estimate], titles: dict[str, str], notes: list[str]) -> Table:
        """A row for each figure with its interval of sampling, and its range between the ensembles if there are any."""
        spread = self.ensembles
        rows = [(titles[name], value_text(name, each.value), sampling_text(name, each),
                 *([spread._range_of(name)] if spread else [])) for name, each in figures.items()]
        if spread:
            notes = [*notes, f"Inputs: {spread._why()}."]
        return Table((type(self).__name__, "", "sampling", *(["inputs"] if spread else [])), rows, notes)


class LineAnswer(_PlaceAnswer):
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
    def energy_translational_kJ(self) -> Estimate:
        """The translational energy."""
        return self._at("ke_translational_J", 1000)

    @property
    def energy_total_kJ(self) -> Estimate:
        """The total energy: with that of spin."""
        return self._at("ke_total_J", 1000)

    def _at(self, key: str, unit: float) -> Estimate:
        return Estimate._of(self.json["whole"]["percentiles"].get(key, {}).get(f"{self.percentile:.15g}"), unit)

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
    def needs_at_upper_end(self) -> Kit | None:
        """The kit for the upper ends of the intervals; None: there are too few rocks."""
        return Kit._of(self.json["whole"]["needs_at_upper_end"])

    @property
    def worst(self) -> Stretch | None:
        """The stretch that asks for the most energy; None: no rock crosses."""
        return self._most("energy_J")

    @property
    def highest(self) -> Stretch | None:
        """The stretch that asks for the highest fence; None: no rock crosses."""
        return self._most("height_m")

    def _most(self, key: str) -> Stretch | None:
        known = [each for each in self.json["sections"] if each["needs"]]
        if not known:
            return None
        found = max(known, key=lambda each: each["needs"][key])
        return Stretch(found["from_m"], found["to_m"], found["rocks"], Kit._of(found["needs"]))

    @property
    def kit(self) -> KitAnswer | None:
        """What the kit that was given would stop."""
        found = self.json["kit"]
        return found and KitAnswer(Kit(found["class"], found["energy_kJ"], found["height_m"]), found["stopped"],
                                   Estimate._of_share(found["share"]), found["above"], found["through"])

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

    def frame(self, table: str = "profile") -> pandas.DataFrame:
        """``"profile"`` or ``"sources"`` as a frame."""
        from .frames import chosen_frame

        return chosen_frame(self, table, ("profile", "sources"))

    def plot(self, figure: str = "energy", **options: Any) -> Axes:
        """As :func:`talus.plots.profile`; ``"sources"``: as :func:`talus.plots.sources`."""
        from . import plots

        return plots.sources(self, **options) if figure == "sources" else plots.profile(self, figure, **options)

    def _percentile(self) -> float:
        return self.percentile

    def _shown(self) -> Table:
        figures = {name: getattr(self, name) for name in
                   ("share", "energy_translational_kJ", "energy_total_kJ", "height_m", "velocity_m_s")}
        figures |= needed(self.needs, self.needs_at_upper_end)
        if not self.standard:
            del figures["needs_class"]
        notes = [f"{self.crossing:,} of {count_text(self.rocks, 'rock')}. {fence_note(self.standard, self.json['applied_factors'])}"]
        if len(self.json["sections"]) > 1:
            notes += [f"Most {what}: {each.text(self.standard)}." for what, each in
                      (("energy", self.worst), ("height", self.highest)) if each]
        if self.json["kit"]:
            notes.append(self.json["kit"]["text"])
        return self._cards(figures, titles_of(self.percentile, self.name or "the line"), notes)


class PolygonAnswer(_PlaceAnswer):
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

    def percentile(self, quantity: str, percentile: float) -> Estimate:
        """Of the maxima of the rocks inside: of ``"ke_total_J"``, ``"ke_translational_J"``, ``"velocity_m_s"`` or
        ``"height_m"``, for the percentiles of the project's design (50, 95 and 99 unless it says otherwise). NaN: there
        is none."""
        return Estimate._of(self.json["percentiles"].get(quantity, {}).get(f"{percentile:.15g}"))

    @property
    def percentiles(self) -> np.ndarray:
        """A row for each quantity and percentile, with its interval."""
        rows = [(quantity, float(percentile), *Estimate._of(found))
                for quantity, of in self.json["percentiles"].items() for percentile, found in of.items()]
        numbers = [(name, "f8") for name in ("percentile", "value", "low", "high")]
        return np.array(rows, dtype=[("quantity", "U20"), *numbers])

    def frame(self, table: str = "percentiles") -> pandas.DataFrame:
        """``"percentiles"`` or ``"sources"`` as a frame."""
        from .frames import chosen_frame

        return chosen_frame(self, table, ("percentiles", "sources"))

    def plot(self, **options: Any) -> Axes:
        """As :func:`talus.plots.sources`."""
        from . import plots

        return plots.sources(self, **options)

    def _percentile(self) -> float:
        known = [float(each) for each in self.json["percentiles"]["ke_total_J"]]
        return 95.0 if 95.0 in known or not known else known[0]

    def _figures(self) -> dict[str, Estimate]:
        def of(key: str, unit: float = 1) -> Estimate:
            return Estimate(*(each / unit for each in self.percentile(key, self._percentile())))

        return {"share": self.entering_share, "stopping_share": self.stopping_share,
                "energy_translational_kJ": of("ke_translational_J", 1000), "energy_total_kJ": of("ke_total_J", 1000),
                "height_m": of("height_m"), "velocity_m_s": of("velocity_m_s")}

    def _shown(self) -> Table:
        return self._cards(self._figures(), titles_of(self._percentile(), "the polygon", is_area=True),
                           [f"{self.entering:,} of {count_text(self.rocks, 'rock')} enter, {self.stopping:,} stop inside."])


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

    def frame(self) -> pandas.DataFrame:
        """A row for each count of rocks: those that get past the toe, end inside, and get beyond the far edge."""
        import pandas

        counts = ("arriving", "inside", "beyond")
        return pandas.DataFrame({"what": counts, "rocks": [getattr(self, each) for each in counts]})

    def _shown(self) -> Table:
        return Table((type(self).__name__, "", "sampling"),
                     [("Retained of those past the toe", value_text("share", self.retained.value),
                       sampling_text("share", self.retained))],
                     [f"{self.arriving:,} of {count_text(self.json['rocks'], 'rock')} get past the toe, {self.inside:,} end "
                      f"inside, {self.beyond:,} get beyond the far edge."])
