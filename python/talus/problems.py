"""What can go wrong, in the user's words."""

from __future__ import annotations

from dataclasses import dataclass
import os
from typing import Any


@dataclass(frozen=True)
class Problem:
    """One problem of a project or of a file that it names.

    Its text has the form ``file:line: where: what (why). hint``.
    """

    severity: str
    """``"error"`` or ``"warning"``."""
    file: str | None
    """The file, as it was named."""
    line: int | None
    """The line of the file, from 1."""
    where: str | None
    """The key or object, for example ``material "Type One"``."""
    what: str | None
    """The problem."""
    why: str | None
    """The reason, with what was expected."""
    hint: str | None
    """What would fix it."""
    path: str | None
    """The setting, for example ``material.0.roughness_deg``."""
    text: str
    """All of this as one line."""
    kind: str | None = None
    """For programs: ``"mostly_on_ground"``, ``"height_below_block"``, ``"kit_below_block"``, ``"beyond_ends"`` or
    ``"models_disagree"``; None for all others."""

    def __str__(self) -> str:
        return self.text


class BadInput(ValueError):
    """Input that cannot be used. All problems are found in one pass."""

    problems: list[Problem]
    """The errors, and the warnings among them."""

    def __init__(self, problems: list[Problem] | str) -> None:
        if isinstance(problems, str):
            problems = [Problem("error", None, None, None, problems, None, None, None, problems)]
        self.problems = list(problems)
        super().__init__("\n".join(problem.text for problem in self.problems))

    def __reduce__(self) -> tuple[Any, ...]:
        return (BadInput, (self.problems,))


def unicode_text(name: str, text: Any) -> str:
    """The text if it is one that files can have."""
    if not isinstance(text, str):
        raise BadInput(f"{name} is {text!r} (expected a text)")
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise BadInput(f"{name}: is not Unicode text ({error.reason})") from None
    return text


def path_text(path: str | bytes | os.PathLike[Any]) -> str:
    """A path as the operating system takes it. Raises TypeError for what is no path."""
    text = os.fsdecode(path)
    if not text or "\0" in text:
        raise BadInput(f"{text!r} is not the path of a file or folder")
    return text


class Interrupted(KeyboardInterrupt):
    """A run that was stopped with Ctrl-C. The rocks done until then are kept."""

    result: Any
    """The results of the rocks done: a :class:`talus.Results`, or a :class:`talus.WhatIf`."""

    def __init__(self, result: Any, done: int, planned: int) -> None:
        self.result = result
        super().__init__(f"stopped after {done} of {planned} rocks; they are in the exception's result")
