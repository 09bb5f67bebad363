"""What if: the same rocks with other values, at a line or in a polygon."""

from __future__ import annotations

from html import escape
from io import StringIO
import json
import os
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple

from . import _talus
from .answers import Kit
from .estimates import Estimate
from .overrides import whole_or_none
from .places import place_of
from .problems import BadInput, Interrupted, Problem, unicode_text
from .project import Project
from .runs import Model, Progress, prepare, progress_of, thread_count
from .shapes import number
from .spoken import about_tables

if TYPE_CHECKING:
    import pandas

__all__ = ["Figures", "Variation", "WhatIf", "what_if"]


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

    @classmethod
    def _of(cls, given: dict[str, Any]) -> Figures:
        return cls(Estimate._of(given["share"]), Estimate._of(given["energy_J"], 1000), Estimate._of(given["height_m"]),
                   Estimate._of(given["velocity_m_s"]), Estimate._of(given.get("runout_m")),
                   Estimate._of(given.get("left")), Kit._of(given.get("needs")))


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


class WhatIf:
    """The figures at a line, or in a polygon, with a project's own values and with each factor a step lower and higher."""

    json: dict[str, Any]
    """Everything, with the keys of what_if.json."""

    def __init__(self, text: str, table: str, warnings: list[Problem]) -> None:
        self.json = json.loads(text)
        self._table, self._warnings = table, warnings

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
        return [Variation(each["factor"], each["step_percent"] and each["step_percent"] / 100, each["text"], each["clipped"], Figures._of(each),
                          Figures._of(each["difference"]), each["difference"]["gained"], each["difference"]["lost"])
                for each in self.json["variations"]]

    @property
    def warnings(self) -> list[Problem]:
        """Doubts about the project and the line."""
        return self._warnings

    def to_pandas(self) -> pandas.DataFrame:
        """A row for the project's own values and one for each variation, the columns of what_if.csv."""
        import pandas

        return pandas.read_csv(StringIO(self._table), float_precision="round_trip", keep_default_na=False,
                               na_values={"step_percent": "", **{key: "" for key in self._numbers()}})

    def _numbers(self) -> list[str]:
        return [name for name in self._table.splitlines()[0].split(",") if name not in ("factor", "changes", "clipped")]

    def __repr__(self) -> str:
        return f"<talus.WhatIf of {len(self.variations)} variations, {self.rocks} of {self.planned} rocks in each>"

    def _repr_html_(self) -> str:
        head = ("", "step", "share [%]", f"energy [kJ], {self.energy_kind}", "height [m]", "velocity [m/s]", "fence then")
        rows = [head, ("own values", "", *_cells(self.base, ""), _fence(self.base))]
        rows += [(each.factor, each.changes if each.step is None else f"{100 * each.step:+g} %", *_cells(each.change, "+"),
                  _fence(each.figures)) for each in self.variations]
        return "<table>" + "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows) + "</table>"


def _fence(figures: Figures) -> str:
    return "" if figures.needs is None else f"{figures.needs.energy_kJ:.3g} kJ, {figures.needs.height_m:.2f} m"


def _cells(figures: Figures, sign: str) -> list[str]:
    def text(figure: Estimate, unit: float = 1) -> str:
        value, low, high = (f"{each * unit:{sign}.3g}" for each in figure)
        return f"{value} ({low} to {high})"

    return [text(figures.share, 100), text(figures.energy_kJ), text(figures.height_m), text(figures.velocity_m_s)]


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
    answer = WhatIf(*found)
    if isinstance(stopped_by, KeyboardInterrupt):
        raise Interrupted(answer, answer.rocks, answer.planned) from None
    if stopped_by is not None:
        raise stopped_by
    return answer
