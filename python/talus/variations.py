"""What if: the same rocks with other values, at a line or in a polygon."""

from __future__ import annotations

from io import StringIO
import json
from math import isnan, nan
import os
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple

from . import _talus
from .estimates import Estimate
from .framed import Framed
from .kits import Kit, fence_text, needed
from .overrides import whole_or_none
from .places import place_of
from .problems import BadInput, Interrupted, Problem, unicode_text
from .project import Project
from .runs import Model, Progress, prepare, progress_of, thread_count
from .shapes import number
from .spoken import about_tables, meant
from .tables import Table
from .texts import (change_text, count_text, fence_note, model_name, sampling_text, spread_text, titles_of, value_text)

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

__all__ = ["Figures", "Range", "Variation", "WhatIf", "what_if"]


class Figures(NamedTuple):
    """Of one set of values; as changes, minus those of the project's own values, for the same rocks."""

    share: Estimate
    """Of the rocks that cross or enter."""
    energy_kJ: Estimate
    """Design percentile of the energy that the check takes."""
    height_m: Estimate
    """Design percentile of the height of the block's top; in a polygon, of the bounce height."""
    velocity_m_s: Estimate
    """Design percentile of the velocity."""
    runout_m: Estimate
    """Design percentile of the runout on plan of all rocks; as a change NaN."""
    left: Estimate
    """Share of all rocks that leave the model; as a change NaN."""
    needs: Kit | None
    """The kit that the standard asks for at a line, with its factors; None: no rock crosses, or as a change."""
    needs_at_upper_end: Kit | None
    """That for the upper ends of the intervals; None: there are too few rocks, too."""
    energy_translational_kJ: Estimate
    """Design percentile of the translational energy."""
    energy_total_kJ: Estimate
    """Design percentile of the total energy: with that of spin."""

    @property
    def needs_class(self) -> Estimate:
        """Energy class of the kit that the standard asks for, with the upper end of its interval."""
        return needed(self.needs, self.needs_at_upper_end)["needs_class"]

    @property
    def needs_energy_kJ(self) -> Estimate:
        """Energy of the kit that the standard asks for, with the upper end of its interval."""
        return needed(self.needs, self.needs_at_upper_end)["needs_energy_kJ"]

    @property
    def needs_height_m(self) -> Estimate:
        """Its height, with the upper end of its interval."""
        return needed(self.needs, self.needs_at_upper_end)["needs_height_m"]

    @classmethod
    def _of(cls, given: dict[str, Any]) -> Figures:
        return cls(Estimate._of(given["share"]), Estimate._of(given["energy_J"], 1000), Estimate._of(given["height_m"]),
                   Estimate._of(given["velocity_m_s"]), Estimate._of(given.get("runout_m")),
                   Estimate._of(given.get("left")), Kit._of(given.get("needs")), Kit._of(given.get("needs_at_upper_end")),
                   Estimate._of(given["ke_translational_J"], 1000), Estimate._of(given["ke_total_J"], 1000))


class Variation(NamedTuple):
    """A factor, a step lower or higher; or another rock model."""

    factor: str
    """``"model"``: another rock model."""
    step: float | None
    """As a share of the value: 0.1 or -0.1; None of a model."""
    changes: str
    """The values before and after, in the units of the project file."""
    clipped: str
    """Values that end at the limit of their range."""
    figures: Figures
    change: Figures
    """Their intervals are those of pairs of the same rocks."""
    gained: int
    """Rocks that cross with the variation alone."""
    lost: int
    """Rocks that cross without it alone."""
    name: str
    """For people: ``"roughness +25 %"``, ``"rigid sphere"``, ``"rigid body (block)"`` with the shapes of its blocks."""
    model: str
    """The rock model, as in a project file: the project's own, or the other one."""

    @classmethod
    def _of(cls, given: dict[str, Any], own_model: str) -> Variation:
        difference, percent = given["difference"], given["step_percent"]
        model = given.get("model", own_model)
        is_model = percent is None
        name = _model_text(model, given["shapes"]) if is_model else f"{given['factor'].replace('_', ' ')} {percent:+g} %"
        return cls(given["factor"], percent and percent / 100, given["text"], given["clipped"], Figures._of(given),
                   Figures._of(difference), difference["gained"], difference["lost"], name, model)


def _model_text(model: str, shapes: list[str]) -> str:
    return model_name(model) + (f" ({', '.join(each.replace('_', ' ') for each in shapes)})" if shapes else "")


class Range(NamedTuple):
    """How far a figure goes over sets of the same rocks, the project's own values included.

    ``low`` and ``high`` are estimates, with their own intervals of sampling; ``at_low`` and ``at_high`` the variations that
    give them, None for the project's own values; ``chance`` what the range may be with the chance of the rocks of each set. As a text
    it says its ends, with units.
    """

    figure: str
    """The name of the figure, such as ``"energy_kJ"``."""
    low: Estimate
    """The lowest, with its own interval of sampling."""
    high: Estimate
    """The highest, with its own interval of sampling."""
    at_low: Variation | None
    """What gives it; None: the project's own values."""
    at_high: Variation | None
    chance: tuple[float, float]
    """The outermost ends of the intervals of sampling of all sets; NaN: the set at that end has too few rocks for one."""

    def __str__(self) -> str:
        return (f"{spread_text(self.figure, self.low.value, self.high.value)}, lowest with {_name_of(self.at_low)} "
                f"({sampling_text(self.figure, self.low)}), highest with {_name_of(self.at_high)} "
                f"({sampling_text(self.figure, self.high)})")


def _name_of(end: Variation | None) -> str:
    return "own values" if end is None else end.name


_compared = {"share": "share", "ke_translational_J": "translational energy", "ke_total_J": "total energy",
             "height_m": "height", "velocity_m_s": "velocity", "runout_m": "runout", "left": "rocks that leave the model"}
_ranged = ("share", "energy_kJ", "energy_translational_kJ", "energy_total_kJ", "height_m", "velocity_m_s", "needs_class",
           "needs_energy_kJ", "needs_height_m", "runout_m", "left")


class WhatIf(Framed):
    """The figures at a line, or in a polygon, with a project's own values and with each factor a step lower and higher."""

    json: dict[str, Any]
    """Everything, with the keys of what_if.json."""

    def __init__(self, text: str, table: str, warnings: list[Problem], place: str, is_area: bool) -> None:
        self.json = json.loads(text)
        self._table, self._warnings, self._place, self._is_area = table, warnings, place, is_area

    @property
    def rocks(self) -> int:
        """Rocks of each set of values."""
        return self.json["rocks"]

    @property
    def planned(self) -> int:
        """Rocks of the project, of which these are a fair sample."""
        return self.json["planned"]

    @property
    def percentile(self) -> float:
        """The design percentile [%]."""
        return self.json["percentile"]

    @property
    def confidence(self) -> float:
        """Of all intervals."""
        return self.json["confidence"]

    @property
    def energy_kind(self) -> str:
        """``"translational"`` or ``"total"``: which energy the check takes."""
        return self.json["energy"]

    @property
    def standard(self) -> str:
        """Whose factors the kits of the figures contain; empty: none."""
        return self.json["standard"] or ""

    @property
    def base(self) -> Figures:
        """With the project's own values."""
        return Figures._of(self.json["base"])

    @property
    def variations(self) -> list[Variation]:
        """The other rock models if they were asked for; then each factor a step lower, and a step higher."""
        return [Variation._of(each, self.model) for each in self.json["variations"]]

    @property
    def model(self) -> str:
        """The project's own rock model, as in a project file."""
        return self.json["model"]

    def inputs_range(self, figure: str = "energy_kJ") -> Range | None:
        """How far a figure goes with the inputs a step lower and higher: one of those of :class:`Figures`, or
        ``"needs_class"``, ``"needs_energy_kJ"`` and ``"needs_height_m"``. None: no inputs were varied, or no rock crosses with any."""
        return self._range(figure, self._inputs())

    def models_range(self, figure: str = "energy_kJ") -> Range | None:
        """How far a figure goes with the rock models, the project's own included; as :meth:`inputs_range`."""
        return self._range(figure, self._models())

    def _inputs(self) -> list[Variation]:
        return [each for each in self.variations if each.step is not None]

    def _models(self) -> list[Variation]:
        return [each for each in self.variations if each.step is None]

    def _range(self, figure: str, sets: list[Variation]) -> Range | None:
        if figure not in _ranged:
            raise BadInput(f"figure={figure!r}: expected {', '.join(_ranged)}{meant(figure, _ranged)}")
        ends = [(getattr(of, figure), each) for of, each in ((self.base, None), *((each.figures, each) for each in sets))]
        known = [end for end in ends if end[0].value == end[0].value]
        if not sets or not known:
            return None
        # Of equal ones the own values; they may differ by rounding.
        (low, at_low), (high, at_high) = (choose(known, key=lambda end: float(f"{end[0].value:.9g}")) for choose in (min, max))
        outermost = (nan if isnan(low.low) else min(each.low for each, _ in known if not isnan(each.low)),
                     nan if isnan(high.high) else max(each.high for each, _ in known if not isnan(each.high)))
        return Range(figure, low, high, at_low, at_high, outermost)

    @property
    def warnings(self) -> list[Problem]:
        """Doubts about the project and the line."""
        return self._warnings

    def frame(self) -> pandas.DataFrame:
        """A row for the project's own values and one for each variation: its name, then the columns of what_if.csv with the
        rock model after the factor."""
        import pandas

        frame = pandas.read_csv(StringIO(self._table), float_precision="round_trip", keep_default_na=False,
                                na_values={"step_percent": "", **{key: "" for key in self._numbers()}})
        frame.insert(0, "name", [_name_of(None), *(each.name for each in self.variations)])
        frame.insert(2, "model", [self.model, *(each.model for each in self.variations)])
        return frame

    def plot(self, figure: str = "energy_kJ", **options: Any) -> Axes:
        """As :func:`talus.plots.changes`."""
        from . import plots

        return plots.changes(self, figure, **options)

    def _numbers(self) -> list[str]:
        return [name for name in self._table.splitlines()[0].split(",") if name not in ("factor", "changes", "clipped")]

    def _shown(self) -> Table:
        """The figures with the project's own values, and their ranges."""
        at_place = ("share", "energy_translational_kJ", "energy_total_kJ", "height_m", "velocity_m_s")
        fence = () if self._is_area else ("needs_class", "needs_energy_kJ", "needs_height_m")
        if not self.standard:
            fence = fence[1:]
        titles = self._titles()
        rows = []
        for figure in (*at_place, *fence) if self._place else ("runout_m", "left"):
            own = getattr(self.base, figure)
            rows.append((titles[figure], value_text(figure, own.value), sampling_text(figure, own),
                         self._range_text(self.inputs_range(figure), self._inputs()),
                         self._range_text(self.models_range(figure), self._models())))
        notes = [f"{self.rocks:,} of {count_text(self.planned, 'rock')} in each of {len(self.variations) + 1} sets, "
                 f"own rock model {model_name(self.model)}."]
        if self._place and fence:
            notes[0] += f" {fence_note(self.standard)}"
        if self.json["models_disagree"]:
            notes.append(self._disagreement())
        return Table((type(self).__name__, "", "sampling", "inputs", "models"), rows, notes)

    def _titles(self) -> dict[str, str]:
        return titles_of(self.percentile, self._place, self._is_area)

    @staticmethod
    def _range_text(found: Range | None, sets: list[Variation]) -> str:
        if found is None:
            return "none crosses" if sets else "not varied"
        return spread_text(found.figure, found.low.value, found.high.value)

    def _disagreement(self) -> str:
        by_model: dict[str, list[str]] = {}
        for each in self.json["models_disagree"]:
            by_model.setdefault(model_name(each["model"]), []).append(_compared[each["figure"]])
        return "Rock models disagree by more than chance: " + "; ".join(
            f"{name} in {', '.join(found)}" for name, found in by_model.items()) + "."

    def __repr__(self) -> str:
        return self._shown().text

    def _repr_html_(self) -> str:
        figures = ("share", "energy_kJ", "height_m", "velocity_m_s")
        head = ["changes", *(self._column(figure) for figure in figures), *([] if self._is_area else ["fence then"])]
        rows = [(each.name, *(change_text(figure, getattr(each.change, figure)) for figure in figures),
                 *([] if self._is_area else [fence_text(each.figures.needs, self.standard)])) for each in self.variations]
        return self._shown().html + (Table(head, rows).html if self._place else "")

    def _column(self, figure: str) -> str:
        titles = {"share": "share", "energy_kJ": f"{self.percentile:g} % {self.energy_kind} energy"}
        return titles.get(figure) or self._titles()[figure]


def what_if(project: Project | Model | str | os.PathLike[str], line: Any = None, *, barrier: str | None = None,
            polygon: Any = None, steps: Mapping[str, float] | None = None, material: str | None = None,
            models: bool = False, within: float | None = None, rocks: int | None = None, threads: int = 0,
            progress: Progress | bool | None = None) -> WhatIf:
    """What changes at a line, or in a polygon, if values of a project are a step lower or higher?

    ``line``, ``barrier``, ``polygon``: one of them, as in :meth:`Results.line` and :meth:`Results.polygon`. ``steps``:
    the factors, and by which share of their value: ``{"mass": 0.5, "roughness": 0.2}``; by default all that the project
    has, by 0.1 or 0.25. ``material``: vary this one alone. ``models``: also the other rock models, with ``steps={}`` they
    alone; then no place need be given, and the answer has the runouts.

    ``within`` [s]: as many rocks as fit into that time;
    ``rocks``: at most so many of each set; by default all, up to 200,000. The rocks have the same draws in all sets.

    ``threads`` and ``progress`` as in :meth:`Model.run`. Ctrl-C raises :class:`talus.Interrupted`, whose ``result`` is the
    answer of the rocks done. Raises :class:`talus.BadInput`.
    """
    is_nowhere = line is None and polygon is None and barrier is None and models
    place = None if is_nowhere else place_of(line, polygon, barrier)
    if steps is not None and not isinstance(steps, Mapping):
        raise BadInput(f'steps={steps!r}: expected factors and their steps, for example {{"mass": 0.5}}')
    shares = None if steps is None else [(str(factor), number(f'steps["{factor}"]', step, -1e9, 1e9))
                                         for factor, step in steps.items()]
    model = project if isinstance(project, Model) else prepare(project)
    seconds = None if within is None else number("within", within, 1, 1e6)
    with about_tables(model.project._table_file):
        *found, stopped_by = _talus.what_if(
            model._core, place, shares, "" if material is None else unicode_text("material", material),
            bool(models), whole_or_none("rocks", rocks, 1), seconds, thread_count(threads), progress_of(progress))
    name = "" if is_nowhere else "the polygon" if polygon is not None else barrier if barrier is not None else "the line"
    answer = WhatIf(*found, name, polygon is not None)
    if isinstance(stopped_by, KeyboardInterrupt):
        raise Interrupted(answer, answer.rocks, answer.planned) from None
    if stopped_by is not None:
        raise stopped_by
    return answer
