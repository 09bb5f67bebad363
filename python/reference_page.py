"""Makes docs/python-reference.md from the docstrings of the package. A test checks that it is up to date."""

from functools import cached_property
import inspect
import re
from typing import Any

import talus
from talus import distributions, flight, impact, plots, settings

HEAD = """# Python reference

Made from the docstrings of the package; [Python](python.md) shows how to use it. The tables of a project have the keys of
[the project file](project-file.md).
"""


def reference_page() -> str:
    parts = [HEAD]
    parts += ["## Functions\n", *entries(talus, [talus.run, talus.prepare, talus.follow, talus.what_if, talus.compare,
                                                talus.calibrate, talus.sensitivity, talus.open_results,
                                                talus.columns, talus.schema])]
    for kind in (talus.Project, talus.Shape, talus.Model, talus.Results, talus.Estimate, talus.LineAnswer,
                 talus.PolygonAnswer, talus.DitchAnswer, talus.Ensembles, talus.WhatIf, talus.Range, talus.Comparison,
                 talus.Calibration, talus.Sensitivity, talus.Map, talus.Trajectory, talus.Surface, talus.BadInput, talus.Problem,
                 talus.Interrupted):
        parts.append(class_text(kind))
    for module in (impact, flight, plots):
        parts += [f"## talus.{module.__name__.split('.')[1]}\n", text_of(module),
                  *entries(module, [getattr(module, name) for name in module.__all__ if callable(getattr(module, name))])]
    parts += ["## Distributions\n", text_of(distributions)]
    parts += [f"- `talus.{name}`: {first(getattr(distributions, name))}" for name in distributions.__all__]
    parts += ["\n## Tables of a project\n"]
    parts += [f"- `talus.{name}`: {sentence(getattr(settings, name))}" for name in settings.__all__]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(parts)).rstrip() + "\n"


def entries(owner: Any, members: list[Any]) -> list[str]:
    name = owner.__name__
    return [entry(f"{name}.{member.__name__}", member) for member in members]


def entry(name: str, member: Any, level: str = "###") -> str:
    if inspect.isclass(member):
        return f"{level} `{name}`\n\n{text_of(member)}\n"
    return f"{level} `{name}{signature(member)}`\n\n{text_of(member)}\n"


def class_text(kind: type) -> str:
    lines = [f"## talus.{kind.__name__}\n", text_of(kind)]
    parts = [kind, *(base for base in kind.__mro__[1:] if base.__name__.startswith("_"))]
    members = [(name, member) for part in parts for name, member in vars(part).items() if not name.startswith("_")]
    for name, member in members:
        if isinstance(member, (property, cached_property)):
            lines.append(f"- `{name}`: {first(member)}")
    lines.append("")
    for name, member in members:
        if isinstance(member, (classmethod, staticmethod)):
            member = member.__func__
        if inspect.isfunction(member) and member.__doc__:
            lines.append(entry(name, member))
    return "\n".join(lines)


def signature(member: Any) -> str:
    text = str(inspect.signature(member))
    text = re.sub(r"^\((self|cls)(, )?", "(", text)
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)  # annotations
    return text.replace("str | os.PathLike[str]", "path").replace("(, *", "(*")


def text_of(member: Any) -> str:
    text = inspect.getdoc(member) or ""
    text = text.replace("::\n", ":\n")
    text = re.sub(r":\w+:`~?([^`]+)`", r"`\1`", text)  # roles of Sphinx
    return text.replace("``", "`") + "\n"


def first(member: Any) -> str:
    """The first paragraph in one line."""
    return " ".join(text_of(member).split("\n\n")[0].split())


def sentence(member: Any) -> str:
    """The first sentence, of which the page of the project file has the others."""
    return re.split(r"[.;] ", first(member))[0].rstrip(".") + "."
