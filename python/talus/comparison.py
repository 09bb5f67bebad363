"""Two runs side by side."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _talus
from .answers import LineAnswer, PolygonAnswer
from .estimates import Estimate
from .framed import Framed
from .kits import fence_text
from .notebook import main_statistics
from .problems import BadInput
from .results import Results
from .tables import Table
from .texts import change_text, count_text, estimate_text, signed_text, titles_of, value_text

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

__all__ = ["Comparison", "Difference", "compare"]

_figures = ("mean", "standard_deviation", "median", "percentiles.95", "maximum")


class Difference(NamedTuple):
    """A setting in which the projects of two runs differ."""

    setting: str
    """``material.Scree.roughness_deg``."""
    first: Any
    """None: it is not set."""
    second: Any


class Comparison(Framed):
    """Two runs side by side: statistics, barriers, settings that differ, and answers at the same line or polygon."""

    first: Results
    """The first run."""
    second: Results
    """The second run."""
    answers: tuple[LineAnswer, LineAnswer] | tuple[PolygonAnswer, PolygonAnswer] | None
    """What both say about the line or polygon that was given."""

    def __init__(self, first: Results, second: Results, answers: Any) -> None:
        self.first, self.second, self.answers = first, second, answers

    @property
    def statistics(self) -> np.ndarray:
        """A row for each quantity of the end points and each figure: of the first run, of the second, and the second minus
        the first."""
        rows = []
        here, there = (run.summary["statistics"] for run in (self.first, self.second))
        for quantity in here:
            for figure in _figures:
                values = [_figure(of.get(quantity, {}), figure) for of in (here, there)]
                rows.append((quantity, figure.replace("percentiles.", "percentile_"), *values, values[1] - values[0]))
        return _table(rows, ("quantity", "figure"), "f8")

    @property
    def barriers(self) -> np.ndarray:
        """A row for each barrier and collector of either run and each outcome of hits on it: how many in each run."""
        counts: dict[tuple[str, str], list[int]] = {}
        for k, run in enumerate((self.first, self.second)):
            for barrier in run.summary["barriers"]:
                for outcome, count in {"hits": barrier["hits"], **barrier["outcomes"]}.items():
                    counts.setdefault((barrier["name"], outcome), [0, 0])[k] = count
        return _table([(*key, *pair, pair[1] - pair[0]) for key, pair in counts.items()], ("barrier", "outcome"), "i8")

    @property
    def at_place(self) -> np.ndarray:
        """With a line or polygon: a row for each figure there, with the intervals of both runs, and the second minus the
        first. Empty without one. How a change of one value acts on the same rocks, with its interval, is the question of
        :func:`talus.what_if`."""
        found = [_figures_of(answer) for answer in self.answers or ()]
        kinds = [("figure", "U24"), *((f"{run}{end}", "f8") for run in ("first", "second") for end in ("", "_low", "_high")),
                 ("difference", "f8")]
        rows = [(name, *found[0][name], *found[1][name], found[1][name].value - found[0][name].value)
                for name in (found[0] if found else ())]
        return np.array(rows, dtype=kinds)

    @property
    def settings(self) -> list[Difference]:
        """The settings in which the projects differ."""
        texts = [json.dumps(run.summary["project"]) for run in (self.first, self.second)]
        return [Difference(each["key"], each["here"], each["there"]) for each in json.loads(_talus.differences(*texts))]

    def frame(self, table: str = "statistics") -> pandas.DataFrame:
        """``"statistics"``, ``"barriers"`` or ``"at_place"`` as a frame."""
        from .frames import chosen_frame

        return chosen_frame(self, table, ("statistics", "barriers", "at_place"))

    def plot(self, column: str = "runout_xy_m", **options: Any) -> Axes:
        """As :func:`talus.plots.distributions`."""
        from . import plots

        return plots.distributions(self, column, **options)

    def _shown(self) -> Table:
        rows = self._rows_at_place() if self.answers else self._rows_of_statistics()
        hits = self.barriers[self.barriers["outcome"] == "hits"]
        rows += [(f"hits on {row['barrier']}", f"{row['first']:,}", f"{row['second']:,}", signed_text(row["difference"]))
                 for row in hits]
        settings = self.settings
        notes = [f"{self.first.rocks_done:,} and {count_text(self.second.rocks_done, 'rock')}; "
                 f"{count_text(len(settings), 'setting')} {'differs' if len(settings) == 1 else 'differ'}."]
        notes += [f"{each.setting}: {_setting_text(each.first)}, then {_setting_text(each.second)}" for each in settings[:5]]
        if len(settings) > 5:
            notes.append("…")
        return Table((type(self).__name__, "first", "second", "difference"), rows, notes)

    def _rows_at_place(self) -> list[tuple[str, ...]]:
        answer = self.answers[0]
        is_area = isinstance(answer, PolygonAnswer)
        titles = titles_of(answer._percentile(), "the polygon" if is_area else answer.name or "the line", is_area)
        if not is_area:
            titles["energy_kJ"] = titles[f"energy_{answer.energy_kind}_kJ"]
        rows = []
        first, second = map(_figures_of, self.answers)
        for name, one in first.items():
            other, title = second[name], titles["share" if name == "entering_share" else name]
            change = Estimate(other.value - one.value, np.nan, np.nan)
            rows.append((title, estimate_text(name, one), estimate_text(name, other), change_text(name, change)))
        if not is_area:
            rows.append(("Fence needed", *(fence_text(each.needs, each.standard) for each in self.answers), ""))
        return rows

    def _rows_of_statistics(self) -> list[tuple[str, ...]]:
        rows = []
        for quantity, label, shown, unit in main_statistics:
            for figure, name in (("mean", "mean"), ("percentiles.95", "95 %")):
                one, other = (_figure(run.summary["statistics"].get(quantity, {}), figure) / unit
                              for run in (self.first, self.second))
                rows.append((f"{label}, {name}", value_text(shown, one), value_text(shown, other),
                             change_text(shown, Estimate(other - one, np.nan, np.nan))))
        return rows

    def __repr__(self) -> str:
        return self._shown().text

    def _repr_html_(self) -> str:
        return self._shown().html


def compare(first: Results, second: Results, *, line: Any = None, barrier: str | None = None,
            polygon: Any = None) -> Comparison:
    """Two runs side by side: how the second differs from the first.

    ``line``, ``barrier``, ``polygon``: a place at which both are asked, as in :meth:`Results.line` and
    :meth:`Results.polygon`. Raises :class:`talus.BadInput`. (``talus compare`` of the program compares rock models:
    ``talus.what_if(project, steps={}, models=True)``.)
    """
    for name, run in (("first", first), ("second", second)):
        if not isinstance(run, Results):
            raise TypeError(f"{name} is {type(run).__name__} (expected the results of a run)")
    if [line, barrier, polygon].count(None) < 2:
        raise BadInput("two places are given (expected one of line, barrier and polygon)")
    answers = None
    if polygon is not None:
        answers = first.polygon(polygon), second.polygon(polygon)
    elif line is not None or barrier is not None:
        answers = first.line(line, barrier=barrier), second.line(line, barrier=barrier)
    return Comparison(first, second, answers)


def _figure(statistics: dict[str, Any], path: str) -> float:
    found: Any = statistics
    for key in path.split("."):
        found = found.get(key) if isinstance(found, dict) else None
    return np.nan if found is None else found


def _figures_of(answer: LineAnswer | PolygonAnswer) -> dict[str, Any]:
    if isinstance(answer, LineAnswer):
        return {name: getattr(answer, name) for name in ("share", "energy_kJ", "height_m", "velocity_m_s")}
    return {"entering_share" if name == "share" else name: each for name, each in answer._figures().items()}


def _table(rows: list[tuple[Any, ...]], words: tuple[str, str], kind: str) -> np.ndarray:
    widths = [max((len(row[k]) for row in rows), default=1) for k in range(2)]
    return np.array(rows, dtype=[*((name, f"U{width}") for name, width in zip(words, widths)), ("first", kind),
                                 ("second", kind), ("difference", kind)])


def _setting_text(value: Any) -> str:
    return "not set" if value is None else value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
