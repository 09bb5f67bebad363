"""Two runs side by side."""

from __future__ import annotations

from html import escape
import json
from typing import TYPE_CHECKING, Any, NamedTuple, Sequence

import numpy as np

from . import _talus
from .answers import LineAnswer, PolygonAnswer
from .problems import BadInput
from .results import Results

if TYPE_CHECKING:
    import pandas

__all__ = ["Comparison", "Difference", "compare"]

_figures = ("mean", "standard_deviation", "median", "percentiles.95", "maximum")


class Difference(NamedTuple):
    """A setting in which the projects of two runs differ."""

    setting: str
    """``material.Scree.roughness_deg``."""
    first: Any
    """None: it is not set."""
    second: Any


class Comparison:
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
        kinds = [("figure", "U20"), *((f"{run}{end}", "f8") for run in ("first", "second") for end in ("", "_low", "_high")),
                 ("difference", "f8")]
        rows = [(name, *found[0][name], *found[1][name], found[1][name].value - found[0][name].value)
                for name in (found[0] if found else ())]
        return np.array(rows, dtype=kinds)

    @property
    def settings(self) -> list[Difference]:
        """The settings in which the projects differ."""
        texts = [json.dumps(run.summary["project"]) for run in (self.first, self.second)]
        return [Difference(each["key"], each["here"], each["there"]) for each in json.loads(_talus.differences(*texts))]

    def to_pandas(self) -> pandas.DataFrame:
        """The statistics as a frame."""
        from .frames import frame_of

        return frame_of(self.statistics)

    def __repr__(self) -> str:
        count = len(self.settings)
        return (f"<talus.Comparison of {self.first.rocks_done} and {self.second.rocks_done} rocks, "
                f"{count} {'setting differs' if count == 1 else 'settings differ'}>")

    def _repr_html_(self) -> str:
        settings = [_html_row(each) for each in self.settings]
        hits = self.barriers[self.barriers["outcome"] == "hits"]
        counts = [_html_row((f"hits on {row['barrier']}", row["first"], row["second"])) for row in hits]
        if self.answers:
            first, second = map(_figures_of, self.answers)
            figures = [_html_row((name, first[name], second[name])) for name in first]
        else:
            rows = self.statistics[np.isin(self.statistics["figure"], ("mean", "percentile_95"))]
            figures = [_html_row((f"{row['quantity']}, {row['figure']}", f"{row['first']:.4g}", f"{row['second']:.4g}"))
                       for row in rows]
        return f"<table>{_html_row(('', 'first', 'second'))}{''.join(settings + counts + figures)}</table>"


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
    return {name: getattr(answer, name) for name in ("entering_share", "stopping_share")}


def _table(rows: list[tuple[Any, ...]], words: tuple[str, str], kind: str) -> np.ndarray:
    widths = [max((len(row[k]) for row in rows), default=1) for k in range(2)]
    return np.array(rows, dtype=[*((name, f"U{width}") for name, width in zip(words, widths)), ("first", kind),
                                 ("second", kind), ("difference", kind)])


def _html_row(cells: Sequence[Any]) -> str:
    return "<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in cells) + "</tr>"
