"""Messages of the engine in the words of Python.

The engine speaks of options of the command line (``--rocks 5``, ``--set material.Scree.roughness_deg=3``) and of tables of
a project file (``[terrain]``). Here they become keyword arguments.
"""

from __future__ import annotations

from contextlib import contextmanager
import dataclasses
from difflib import get_close_matches
import json
import re
import tomllib
from typing import Any, Iterable, Iterator

from .overrides import declared
from .problems import BadInput, Problem

_keywords = "rocks|rock|seed|threads|line|polygon|barrier|height|energy|material|within"
_option = re.compile(rf"--({_keywords})\b(?: (?=[\w.\"-])([^\s,;:()]+))?")
_functions = {"new": "talus.Project.starter()", "calibrate": "talus.calibrate", "sensitivity": "talus.sensitivity"}
_command = re.compile(rf"`?\btalus ({'|'.join(_functions)})\b`?")
_setting = re.compile(r"--set (.+?=)(\.\.\.|.+)", re.DOTALL)
_table = re.compile(r"\[\[(\w+)\]\]|\[(\w+)\]")


def spoken(text: str, is_of_setting: bool) -> str:
    """Part of a message. ``is_of_setting``: it is about a keyword argument, not about a file."""
    given = _setting.search(text)
    if given:
        return text[:given.start()] + _as_keyword(given[1], given[2])
    if is_of_setting:
        text = _without_brackets(text)
    text = _option.sub(lambda found: f"{found[1]}={found[2]}" if found[2] else found[1], text)
    return _command.sub(lambda found: _functions[found[1]], text)


def _as_keyword(path: str, value: str) -> str:
    """``material={"Scree": {"roughness_deg": 3}}`` of ``material.Scree.roughness_deg=`` and ``3``."""
    if value == "...":
        return _as_keyword(path, '"..."').replace('"..."', "...")
    try:
        (name, tables), = tomllib.loads(path + value).items()
    except (tomllib.TOMLDecodeError, ValueError):
        return path + value
    return f"{name}={_literal(tables)}"


def _literal(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key, ensure_ascii=False)}: {_literal(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_literal, value)) + "]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


def _without_brackets(text: str) -> str:
    def as_keyword(found: re.Match[str]) -> str:
        is_table = (found[1] or found[2]) in declared() or text[:found.start()].endswith("unknown table ")
        if not is_table:  # a unit, an index
            return found[0]
        return f"{found[1]}=[...]" if found[1] else found[2]

    return _table.sub(as_keyword, text)


@contextmanager
def about_tables(file: str | None) -> Iterator[None]:
    """Problems of a project that was made of tables in Python: without its file, which there is not. None: there is."""
    try:
        yield
    except BadInput as bad:
        if file is None:
            raise
        raise BadInput([_without_file(problem, file) for problem in bad.problems]) from None


def _without_file(problem: Problem, file: str) -> Problem:
    if problem.file != file:
        return problem
    place = file if problem.line is None else f"{file}:{problem.line}"
    parts = {key: _without_brackets(text) for key in ("where", "what", "why", "hint")
             if (text := getattr(problem, key)) is not None}
    return dataclasses.replace(problem, file=None, line=None,
                               text=_without_brackets(problem.text.removeprefix(f"{place}: ")), **parts)


def meant(name: Any, names: Iterable[str]) -> str:
    """``. Did you mean "velocity_max_m_s"?``, or nothing."""
    near = get_close_matches(name, list(names), 1, 0.6) if isinstance(name, str) else []
    return f'. Did you mean "{near[0]}"?' if near else ""
