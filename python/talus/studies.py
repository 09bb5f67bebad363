"""Calibrations and sensitivity studies, from their files."""

from __future__ import annotations

from functools import cached_property
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _talus
from .problems import Problem, path_text
from .project import Project
from .runs import Progress, progress_of, thread_count

if TYPE_CHECKING:
    import pandas

__all__ = ["Calibration", "Sensitivity", "calibrate", "sensitivity"]


class _Study:
    """What a study wrote into its folder."""

    folder: Path
    """Where its files are."""

    def __init__(self, folder: Path, warnings: list[Problem]) -> None:
        self.folder, self._warnings = folder, warnings

    @property
    def warnings(self) -> list[Problem]:
        """Doubts about the study and what it found."""
        return self._warnings

    @cached_property
    def summary(self) -> dict[str, Any]:
        """What summary.json says."""
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))

    @property
    def report(self) -> Path:
        """The report, a page that needs no network."""
        return self.folder / "report.html"

    def _frame(self, name: str) -> pandas.DataFrame:
        import pandas

        return pandas.read_csv(self.folder / name, float_precision="round_trip")


class Calibration(_Study):
    """The sets of parameters that agree with observed rocks."""

    @property
    def posterior(self) -> pandas.DataFrame:
        """A row for each set that counts: ``weight``, ``score`` and a column for each parameter. The weights add up to 1."""
        return self._frame("posterior.csv")

    @property
    def sets(self) -> pandas.DataFrame:
        """A row for each set that was simulated, with its log-likelihood and whether it agrees."""
        return self._frame("sets.csv")

    @property
    def parameters(self) -> pandas.DataFrame:
        """A row for each parameter: its unit, and quantiles of the posterior: ``p05`` to ``p95``."""
        import pandas

        rows = [{"unit": each["unit"], **(each["posterior"] or {})} for each in self.summary["parameters"]]
        return pandas.DataFrame(rows, index=[each["name"] for each in self.summary["parameters"]])

    @property
    def best(self) -> dict[str, Project]:
        """By site the project with the values of the least score. Predict with the whole posterior instead: a project
        takes its file as ``sampling={"parameters": ...}``."""
        return {file.stem: Project.read(file) for file in sorted((self.folder / "best").glob("*.toml"))}

    def frame(self, table: str = "parameters") -> pandas.DataFrame:
        """``"parameters"``, ``"posterior"`` or ``"sets"``."""
        from .frames import chosen_frame

        return chosen_frame(self, table, ("parameters", "posterior", "sets"))

    def __repr__(self) -> str:
        return f"<talus.Calibration in {self.folder}>"

    def _repr_html_(self) -> str:
        return self.parameters.to_html(float_format="{:.4g}".format)


class Sensitivity(_Study):
    """Which inputs of a project its results depend on."""

    @property
    def effects(self) -> pandas.DataFrame:
        """A row for each input and result: its effect with its interval, the columns of sensitivity.csv."""
        return self._frame("sensitivity.csv")

    @property
    def runs(self) -> pandas.DataFrame:
        """A row for each run: the values of the inputs and of the results."""
        return self._frame("runs.csv")

    def frame(self, table: str = "effects") -> pandas.DataFrame:
        """``"effects"`` or ``"runs"``."""
        from .frames import chosen_frame

        return chosen_frame(self, table, ("effects", "runs"))

    def __repr__(self) -> str:
        return f"<talus.Sensitivity in {self.folder}>"

    def _repr_html_(self) -> str:
        return self.effects.dropna(axis="columns", how="all").to_html(float_format="{:.4g}".format)


def calibrate(study: str | os.PathLike[str], *, folder: str | os.PathLike[str] | None = None, threads: int = 0,
              progress: Progress | bool | None = None) -> Calibration | dict[str, Calibration]:
    """Finds the parameters that agree with observed rocks, as ``talus calibrate`` does.

    ``study``: a study file. ``folder``: for the results; by default named after the study, beside it. With several models
    in the study, a dictionary of them by their names; ``models.csv`` in the folder compares them.

    ``progress``: a function of the sets done and all sets; True: a bar. Ctrl-C raises KeyboardInterrupt: finished sets are
    in the folder, and the same call continues from there. Raises :class:`talus.BadInput`.
    """
    place, models, warnings = _talus.calibrate(path_text(study), _folder(folder), thread_count(threads),
                                               progress_of(progress, "sets"))
    place = Path(place)
    if not models:
        return Calibration(place, warnings)
    return {name: Calibration(place / f"model-{k}", warnings) for k, name in enumerate(models, 1)}


def sensitivity(study: str | os.PathLike[str], *, folder: str | os.PathLike[str] | None = None, threads: int = 0,
                progress: Progress | bool | None = None) -> Sensitivity:
    """Finds which inputs of a project its results depend on, as ``talus sensitivity`` does.

    The arguments are those of :func:`talus.calibrate`, but for a study file of a sensitivity study; ``progress`` is called with the number of
    runs.
    """
    place, warnings = _talus.sensitivity(path_text(study), _folder(folder), thread_count(threads),
                                         progress_of(progress, "runs"))
    return Sensitivity(Path(place), warnings)


def _folder(folder: str | os.PathLike[str] | None) -> str | None:
    return None if folder is None else path_text(folder)

