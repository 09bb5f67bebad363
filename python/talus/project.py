"""A project: a slope, its materials, where rocks start, barriers and settings."""

from __future__ import annotations

import json
import os
from pathlib import Path
import re
from typing import Any, Iterator
import warnings

from . import _talus
from .overrides import declared, overrides, whole_or_none
from .problems import BadInput, Problem, path_text, unicode_text
from .spoken import about_tables
from .toml_text import plain, project_text

__all__ = ["Project"]


class Project:
    """A checked project, which does not change.

    Make one from a file (:meth:`read`), from text (:meth:`from_text`), or from typed tables whose keys are those of the
    project file::

        project = talus.Project(
            name="Slope",
            terrain=talus.Terrain(section=[[0, 50], [40, 10], [80, 0]]),
            material=[talus.Material(name="Rock", normal_restitution=talus.Normal(0.35, 0.04))],
            seeder=[talus.Seeder(name="Crest", position=[1, "surface"], rocks=100, mass_kg=500)],
        )

    Tables may be dictionaries, too. Files that the project names are relative to ``folder``, by default the current
    one at the time when they are read. Raises :class:`talus.BadInput` with all problems at once.
    """

    def __init__(self, *, folder: str | os.PathLike[str] = ".", **tables: Any) -> None:
        text = unicode_text("the project", project_text(_in_order(plain(tables))))
        name = re.sub(r"[/\0]", "_", str(tables.get("name") or "project"))
        file = Path(path_text(folder)) / f"{name}.toml"
        self._table_file = str(file)
        with about_tables(self._table_file):
            self._core = _talus.Project.from_text(text, file, [], None, None)

    _table_file: str | None = None
    """The name that the engine has for its file, if it was made of tables: there is no such file."""

    @classmethod
    def read(cls, file: str | os.PathLike[str], *, rocks: int | None = None, seed: int | None = None,
             **settings: Any) -> Project:
        """Reads a project file (TOML).

        ``rocks``: total number of rocks, which several seeders share in proportion; ``seed``: of all draws. Other
        settings are changed by their tables and keys: ``analysis={"gravity_m_s2": 9.81}``.
        """
        return cls._of(_talus.Project.read(path_text(file), *_changes(settings, rocks, seed)))

    @classmethod
    def from_text(cls, text: str, *, file: str | os.PathLike[str] = "project.toml", rocks: int | None = None,
                  seed: int | None = None, **settings: Any) -> Project:
        """A project from the text of a file, whose name is used in messages and for relative paths."""
        name = path_text(file)
        return cls._of(_talus.Project.from_text(unicode_text(name, text), name, *_changes(settings, rocks, seed)))

    @classmethod
    def starter(cls) -> Project:
        """The project that ``talus new`` writes: a small slope, ready to run."""
        return cls.from_text(_talus.starter_text(), file="slope.toml")

    @classmethod
    def _of(cls, core: Any) -> Project:
        project = cls.__new__(cls)
        project._core = core
        return project

    def changed(self, *, rocks: int | None = None, seed: int | None = None, **settings: Any) -> Project:
        """The project with other settings: ``project.changed(material={"Scree": {"roughness_deg": 5}})``."""
        with about_tables(self._table_file):
            changed = Project._of(self._core.changed(*_changes(settings, rocks, seed)))
        changed._table_file = self._table_file
        return changed

    @property
    def name(self) -> str:
        """Its name, or that of its file."""
        return self._core.name

    @property
    def file(self) -> Path:
        """The file that it was read from, or to which its relative paths refer."""
        return Path(self._core.file)

    @property
    def is_2d(self) -> bool:
        """Whether the terrain is a section."""
        return self._core.is_2d

    @property
    def text(self) -> str:
        """The text of its file; with changed settings, all settings with the changed values."""
        return self._core.text if not self._core.is_changed else project_text(self.settings)

    @property
    def settings(self) -> dict[str, Any]:
        """All settings with their defaults, as in a run's summary."""
        return with_infinity(json.loads(self._core.echo_text()))

    @property
    def warnings(self) -> list[Problem]:
        """Doubts about its settings."""
        return self._core.warnings

    def write(self, file: str | os.PathLike[str]) -> Path:
        """Writes it as a project file, in the layout of the workbench. Replaces no file unless it is complete.

        Files that it names are not copied: a warning names those that are not beside the new file.
        """
        path = Path(path_text(file))
        if path.is_dir():
            raise BadInput(f"{path}: cannot be written (it is a folder)")
        part = path.with_name(path.name + ".part")
        try:
            part.write_text(self.text, encoding="utf-8", newline="\n")
            os.replace(part, path)
        except OSError as error:
            part.unlink(missing_ok=True)
            raise BadInput(f"{path}: cannot be written ({error.strerror})") from None
        lacking = [name for name in self._files() if not (path.parent / name).exists()]
        if lacking:
            warnings.warn(f"{path}: there is no {', '.join(lacking)} beside it, which this project names", stacklevel=2)
        return path

    def _files(self) -> list[str]:
        """The files that its tables name."""
        named = [row[key] for row, key, setting in _given(self.settings) if _is_of_files(setting)]
        return [each for value in named for each in (value if isinstance(value, list) else [value]) if isinstance(each, str)]

    def __repr__(self) -> str:
        return f"<talus.Project {self.name!r}, {'section' if self.is_2d else '3D'}, {self.file}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (self.text, str(self.file)))


def with_infinity(settings: dict[str, Any]) -> dict[str, Any]:
    """Echoed settings with numbers for "inf", which JSON does not have."""
    for row, key, setting in list(_given(settings)):
        if row[key] == "inf" and setting.get("x-infinite"):
            row[key] = float("inf")
    return settings


def _given(settings: dict[str, Any]) -> Iterator[tuple[dict[str, Any], str, dict[str, Any]]]:
    """Each value of the tables: its row, its key and its declaration."""
    for name, rows in settings.items():
        table = declared()[name]
        keys = table.get("items", table).get("properties", {})
        for row in rows if isinstance(rows, list) else [rows] if isinstance(rows, dict) else []:
            for key in row:
                yield row, key, keys.get(key, {})


def _changes(settings: dict[str, Any], rocks: int | None, seed: int | None) -> tuple[list[str], int | None, int | None]:
    return overrides(settings), whole_or_none("rocks", rocks, 1), whole_or_none("seed", seed)


def _is_of_files(setting: dict[str, Any]) -> bool:
    kinds = setting.get("anyOf", [setting])
    return any(kind.get("x-file") or kind.get("items", {}).get("x-file") for kind in kinds)


def _restored(text: str, file: str) -> Project:
    return Project.from_text(text, file=file)


def _in_order(tables: dict[str, Any]) -> dict[str, Any]:
    """In the order of the reference; unknown names last, for the reader to refuse."""
    known = [key for key in declared() if key in tables]
    return {key: tables[key] for key in known + [key for key in tables if key not in known]}
