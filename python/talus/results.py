"""The results of a run: in memory, or in a folder."""

from __future__ import annotations

import copy
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Mapping, NamedTuple

import numpy as np

from . import _talus
from .answers import DitchAnswer, LineAnswer, PolygonAnswer
from .maps import Map
from .overrides import overrides
from .places import place_of
from .problems import BadInput, path_text
from .project import Project, with_infinity
from .shapes import number
from .spoken import meant
from .surface import Surface

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

__all__ = ["Column", "Results", "columns", "open_results"]

_tables = ("end_points", "events", "barrier_hits", "impacts", "envelopes")


class Column(NamedTuple):
    """A column of a table."""

    name: str
    unit: str
    """Empty: none."""
    meaning: str


def columns(table: str) -> list[Column]:
    """The columns of a table: ``"end_points"``, ``"events"``, ``"barrier_hits"``, ``"impacts"`` or ``"envelopes"``.

    Those of envelopes are given with ``…`` where a name contains max, mean or a percentile.
    """
    found = _talus.columns(table) if isinstance(table, str) else None
    if found is None:
        raise BadInput(f"there is no table {table!r} (expected {', '.join(_tables)}){meant(table, _tables)}")
    return [Column(*column) for column in found]


class Results:
    """The results of a run.

    Tables are structured arrays of NumPy, which cannot be written to; their columns are those of the files that a run
    writes (:func:`columns`). Cells that are empty there are NaN, or -1 for whole numbers.
    """

    def __init__(self, source: _talus.Run | _InFolder) -> None:
        self._source = source
        self._summary: dict[str, Any] | None = None
        self._made: dict[str, np.ndarray] = {}
        self._to_ask: Any = None

    @property
    def end_points(self) -> np.ndarray:
        """How each rock ended: a row per rock, the columns of endpoints.csv."""
        return self._table("end_points")

    @property
    def events(self) -> np.ndarray:
        """The moments of the trajectories: release, arrival and departure at every contact, end; as in paths.csv."""
        return self._table("events")

    @property
    def barrier_hits(self) -> np.ndarray:
        """A row per arrival at a barrier or collector, the columns of barriers.csv."""
        return self._table("barrier_hits")

    @property
    def impacts(self) -> np.ndarray:
        """A row per impact on the ground, as in impacts.csv; empty unless the project asks for them (output.impacts)."""
        return self._table("impacts")

    @property
    def envelopes(self) -> np.ndarray:
        """In a section: energy, velocity, bounce height and counts along x, as in envelopes.csv. In 3D see :attr:`maps`."""
        if "envelopes" not in self._made:
            self._made["envelopes"] = self._source.envelopes()
        return self._made["envelopes"]

    def _table(self, name: str) -> np.ndarray:
        if name not in self._made:
            self._made[name] = self._source.table(name)
        return self._made[name]

    def frame(self, table: str = "end_points") -> pandas.DataFrame:
        """A table as a frame of pandas, words as categories: ``result.frame("barrier_hits")``."""
        from .frames import frame_of

        columns(table)  # refuses unknown names
        return frame_of(getattr(self, table))

    def plot(self, **options: Any) -> Axes:
        """Of a section :func:`talus.plots.section`, in 3D :func:`talus.plots.plan`."""
        from . import plots

        is_section = self.summary["terrain"]["kind"] == "section"
        return plots.section(self, **options) if is_section else plots.plan(self, **options)

    @property
    def maps(self) -> Mapping[str, Map]:
        """In 3D: the maps by name, each as a masked array with its place: ``result.maps["energy_total_p95_kJ"]``.

        The unit at the end of a name may be left out; ``kinetic_energy`` is the total.
        """
        return _Maps(self._source)

    def line(self, line: Any = None, *, barrier: str | None = None, height: float | None = None,
             energy: float | None = None, stretch: float | None = None,
             design: Mapping[str, Any] | None = None) -> LineAnswer:
        """Which rocks cross a line on plan, and how fast, high and strong they are there.

        ``line``: its corners, (n, 2) [m]; in a section a place x; a LineString of shapely, in the coordinate system of the
        terrain; or the path of a GIS file or table with one line. ``barrier``: instead, the name of a barrier or
        collector of the run.

        ``height`` [m] and ``energy`` [kJ]: of a kit on the line: what does it stop? ``stretch`` [m]: length of the parts
        of the profile; by default a twentieth of the line, about. ``design``: other values of the project's table
        ``design``: ``{"standard": "none"}``.

        The run must have kept its trajectories (``output={"trajectories": "all"}``; by default it keeps up to 10,000).
        """
        return LineAnswer(*self._ask(place_of(line, None, barrier), height, energy, stretch, design))

    def polygon(self, polygon: Any, *, design: Mapping[str, Any] | None = None) -> PolygonAnswer:
        """Which rocks enter a polygon on plan, and which stop in it: its corners, (n, 2) [m], a Polygon of shapely, or
        the path of a GIS file with one polygon. As :meth:`line`."""
        return PolygonAnswer(*self._ask(place_of(None, polygon, None), None, None, None, design))

    def ditch(self, toe: float, far_edge: float) -> DitchAnswer:
        """In a section: what rocks do between the toe and the far edge of a ditch or bench, places x [m]."""
        asked = self._asked()
        return DitchAnswer(asked, asked.ditch(number("toe", toe, -1e9, 1e9), number("far_edge", far_edge, -1e9, 1e9)))

    def _ask(self, place: Any, height: float | None, energy: float | None, stretch: float | None,
             design: Mapping[str, Any] | None) -> tuple[Any, Any]:
        if (height is None) != (energy is None):
            raise BadInput(f"{'height' if height is None else 'energy'} is missing (a kit has a height and an energy)")
        kit = None if height is None else (number("height", height, 1e-3, 1e3), number("energy", energy, 1e-3, 1e9))
        length = None if stretch is None else number("stretch", stretch, 1e-3, 1e9)
        asked = self._asked()
        return asked, asked.ask(place, kit, length, overrides({"design": design}) if design else [])

    def _asked(self) -> Any:
        if self._to_ask is None:
            in_folder = isinstance(self._source, _InFolder)
            self._to_ask = self._source.asked() if in_folder else _talus.Asked(self._source)
        return self._to_ask

    @property
    def summary(self) -> dict[str, Any]:
        """What summary.json says: counts, statistics, barriers, the project with its defaults, warnings."""
        if self._summary is None:
            try:
                self._summary = json.loads(self._source.summary_text())
            except (ValueError, RecursionError) as error:
                raise BadInput(f"summary.json: this is not the summary of a run ({error})") from None
            if not isinstance(self._summary, dict):
                raise BadInput("summary.json: this is not the summary of a run (expected an object)")
        return self._summary

    @property
    def surface(self) -> Surface | None:
        """The terrain of a run in memory; None of a folder."""
        return Surface(self._source) if isinstance(self._source, _talus.Run) else None

    @property
    def project(self) -> Project:
        """The project with all its settings, from the summary. Files that it names are relative to the current folder."""
        return Project(**with_infinity(copy.deepcopy(self.summary["project"])))

    @property
    def name(self) -> str:
        """The name of the project."""
        return self.summary["name"]

    @property
    def rocks(self) -> int:
        """The number of rocks of the run."""
        return self._source.rocks

    @property
    def rocks_done(self) -> int:
        """The number of rocks simulated: fewer if the run was stopped."""
        return self._source.done

    @property
    def is_complete(self) -> bool:
        """Whether all rocks were simulated."""
        return self.rocks_done == self.rocks

    @property
    def warnings(self) -> list[str]:
        """Doubts about the project, its terrain and its rocks."""
        return self.summary.get("warnings", [])

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes the files that ``talus run`` writes, with the same bytes except for the timings in summary.json."""
        self._source.save(path_text(folder))
        return Path(path_text(folder))

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("results cannot be copied to another process (copy their tables, or save them and open the folder)")

    def __repr__(self) -> str:
        return f"<talus.Results of {self.rocks_done} of {self.rocks} rocks>"

    def _repr_html_(self) -> str:
        from .notebook import html_of

        return html_of(self)


class _Maps(Mapping[str, Map]):
    def __init__(self, source: _talus.Run | _InFolder) -> None:
        self._source = source
        self._names = source.map_names()

    def __getitem__(self, name: str) -> Map:
        full = self._full_name(name)
        found = self._source.map(full) if full else None
        if found is None:
            raise KeyError(f"there is no map {name!r} (there are {', '.join(self._names) or 'none'})"
                           f"{meant(name, self._names)}")
        return Map._of(full, found, self._source.crs_wkt)

    def _full_name(self, name: object) -> str | None:
        if not isinstance(name, str):
            return None
        name = name.replace("kinetic_energy_", "energy_total_")
        if name in self._names:
            return name
        longer = [each for each in self._names if each.startswith(f"{name}_")]
        return longer[0] if len(longer) == 1 else None

    def __contains__(self, name: object) -> bool:
        return self._full_name(name) is not None

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return f"<maps: {', '.join(self._names)}>"


class _InFolder:
    """The results in a folder, in place of a run in memory. Files are read when they are asked for."""

    def __init__(self, folder: str, files: str = "") -> None:
        self.folder, self.files = folder, files
        try:
            self.text = Path(folder, "summary.json").read_text(encoding="utf-8")
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or "it is not text"
            raise BadInput(f"{Path(folder, 'summary.json')}: cannot be read ({reason}). "
                           "Give the folder of a run that is finished") from None

    def table(self, name: str) -> np.ndarray:
        if name == "impacts" and not Path(self.folder, "impacts.csv").exists():
            return np.empty(0, dtype=[(column.name, "f8") for column in columns(name)])
        return _talus.table_of_folder(self.folder, name)

    def envelopes(self) -> np.ndarray:
        if not Path(self.folder, "envelopes.csv").exists():
            return np.empty(0, dtype=[("x_m", "f8")])
        return _talus.envelopes_of_folder(self.folder)

    def summary_text(self) -> str:
        return self.text

    def map_names(self) -> list[str]:
        return _talus.maps_of_folder(self.folder)

    def map(self, name: str) -> Any:
        return _talus.map_of_folder(self.folder, name)

    @property
    def crs_wkt(self) -> str:
        return json.loads(self.text).get("terrain", {}).get("crs_wkt", "")

    @property
    def rocks(self) -> int:
        return json.loads(self.text)["rocks"]["planned"]

    @property
    def done(self) -> int:
        return json.loads(self.text)["rocks"]["done"]

    def asked(self) -> Any:
        return _talus.Asked(self.folder, self.files)

    def save(self, folder: str) -> None:
        raise BadInput(f"{self.folder}: these results are in a folder already. Copy it")


def open_results(folder: str | os.PathLike[str], *, files: str | os.PathLike[str] | None = None) -> Results:
    """Reads the folder of a run, of this package or of the program. Raises :class:`talus.BadInput`.

    ``files``: the folder of the project's files, for questions about lines, for which the terrain is built again; by
    default the one that ``folder`` is in.
    """
    source = _InFolder(path_text(folder), "" if files is None else path_text(files))
    result = Results(source)
    rocks = result.summary.get("rocks")
    parts = {"name": str, "rocks": dict, "end_reasons": dict, "statistics": dict, "barriers": list, "terrain": dict,
             "project": dict}
    lacking = [key for key, kind in parts.items() if not isinstance(result.summary.get(key), kind)]
    if not lacking and not all(isinstance(rocks.get(key), int) for key in ("planned", "done")):
        lacking = ["rocks"]
    if lacking:
        raise BadInput(f"{Path(source.folder, 'summary.json')}: this is not the summary of a run "
                       f"(it has no {', '.join(lacking)})")
    return result
