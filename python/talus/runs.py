"""Runs in memory."""

from __future__ import annotations

import os
import sys
from typing import Any, Callable

from . import _talus
from .overrides import overrides, whole, whole_or_none
from .problems import BadInput, Interrupted, Problem
from .project import Project
from .results import Results
from .spoken import about_tables
from .surface import Surface
from .trajectory import Trajectory

__all__ = ["Model", "follow", "prepare", "run"]

Progress = Callable[[int, int], Any]


class Model:
    """A project whose terrain is read and on which everything is placed once, for many runs.

    It can be used from several threads at the same time.
    """

    def __init__(self, project: Project) -> None:
        if not isinstance(project, Project):
            raise TypeError(f"a model is made of a Project, not of {project!r} (see prepare)")
        self.project = project
        """The project of which it was made."""
        with about_tables(project._table_file):
            self._core = _talus.Model(project._core)

    @property
    def rocks(self) -> int:
        """The number of rocks of a run without other settings."""
        return self._core.rocks

    @property
    def warnings(self) -> list[Problem]:
        """Doubts about the project and its terrain."""
        return self._core.warnings

    @property
    def crs_wkt(self) -> str:
        """The coordinate system of the terrain; empty if it is unknown."""
        return self._core.crs_wkt

    def run(self, *, rocks: int | None = None, seed: int | None = None, threads: int = 0,
            progress: Progress | bool | None = None, **settings: Any) -> Results:
        """Simulates the rocks, and returns their results.

        ``rocks``: total number of rocks, which several seeders share in proportion. ``seed``: of all draws: a run with
        the same seed has the same rocks. ``threads``: 0: as many as there are cores; results do not depend on it.

        ``progress``: a function of the rocks done and all rocks, called from time to time; True: a bar, with tqdm if it
        is installed.

        Other settings are changed for this run by their tables and keys:
        ``model.run(material={"Scree": {"normal_restitution": 0.3}})``. Values of materials, laws and capacities, sizes
        and velocities of rocks take no time; others are placed on the terrain again, which is not read again. Those of
        [terrain], [ground] and [[area]] are refused.

        Ctrl-C in the main thread raises :class:`talus.Interrupted`, whose ``result`` has the rocks done. Raises :class:`talus.BadInput`.
        """
        with about_tables(self.project._table_file):
            core, stopped_by = self._core.run(overrides(settings), whole_or_none("rocks", rocks, 1),
                                              whole_or_none("seed", seed), thread_count(threads), progress_of(progress))
        result = Results(core)
        if isinstance(stopped_by, KeyboardInterrupt):
            raise Interrupted(result, result.rocks_done, result.rocks) from None
        if stopped_by is not None:
            raise stopped_by
        return result

    @property
    def surface(self) -> Surface:
        """Its terrain."""
        return Surface(self._core)

    def follow(self, rock: int) -> Trajectory:
        """The trajectory of one rock by its number, from 0: the same as in a run."""
        return Trajectory(_talus.follow(self._core, whole("rock", rock)))

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("a model cannot be copied to another process (copy its project, and prepare that there)")

    def __repr__(self) -> str:
        return f"<talus.Model of {self.project!r}, {self.rocks} rocks>"


def prepare(project: Project | str | os.PathLike[str]) -> Model:
    """Reads the terrain of a project, or of a project file, and places everything on it, for many runs."""
    return Model(project_of(project))


def follow(project: Project | str | os.PathLike[str], rock: int) -> Trajectory:
    """The trajectory of one rock of a project, or of a project file, by its number from 0."""
    return prepare(project).follow(rock)


def run(project: Project | str | os.PathLike[str], *, rocks: int | None = None, seed: int | None = None,
        threads: int = 0, progress: Progress | bool | None = None, **settings: Any) -> Results:
    """Simulates a project, or a project file, in memory. The arguments are those of :meth:`Model.run`."""
    project = project_of(project)
    if rocks is not None or seed is not None or settings:
        project = project.changed(rocks=rocks, seed=seed, **settings)
    return prepare(project).run(threads=threads, progress=progress)


def project_of(project: Project | str | os.PathLike[str]) -> Project:
    if isinstance(project, Project):
        return project
    if isinstance(project, Model):
        raise TypeError("this is a model, not a project (use its own run and follow)")
    if not isinstance(project, (str, os.PathLike)):
        raise TypeError(f"expected a Project or the path of a project file, not {type(project).__name__}")
    return Project.read(project)


def thread_count(threads: int) -> int:
    most = 1024
    number = whole("threads", threads)
    if number > most:
        raise BadInput(f"threads={threads}: expected 0 to {most}. 0 uses all cores")
    return number


def progress_of(progress: Progress | bool | None, unit: str = "rocks") -> Progress | None:
    if progress is None or progress is False:
        return None
    if progress is not True:
        if not callable(progress):
            raise BadInput(f"progress={progress!r}: expected a function of what is done and all that is to do, or True")
        return progress
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return lambda done, planned: _print_progress(done, planned, unit)
    bar = tqdm(unit=f" {unit}")

    def show(done: int, planned: int) -> None:
        bar.total = planned
        bar.update(done - bar.n)
        if done == planned:
            bar.close()

    return show


def _print_progress(done: int, planned: int, unit: str) -> None:
    print(f"\r{done} of {planned} {unit}", end="\n" if done == planned else "", file=sys.stderr, flush=True)
