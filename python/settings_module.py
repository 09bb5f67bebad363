"""Makes talus/settings.py from the declaration of the settings. A test checks that it is up to date."""

import json
import re
import textwrap
from typing import Any

HEAD = '''"""The tables of a project file as classes. Made by settings_module.py from the declaration of the settings.

A setting that is not given (None) has its default. Numbers are in the unit that the name of the setting ends with.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
import os
from typing import Any, Literal, Mapping, Sequence, Union

import numpy as np

from .distributions import _Distribution, Empirical

__all__ = [{names}]

Real = Union[float, "np.floating[Any]", "np.integer[Any]"]
Property = Union[Real, _Distribution, Empirical, Mapping[str, Any]]
"""A number, or a distribution that is drawn for each rock."""
File = Union[str, "os.PathLike[str]"]


class Table:
    """A table of a project file."""

    def settings(self) -> dict[str, Any]:
        """What is given, by key."""
        given = ((field.name, getattr(self, field.name)) for field in fields(self))  # type: ignore[arg-type]
        return {{key: value for key, value in given if value is not None}}
'''


def settings_module(schema: dict[str, Any]) -> str:
    tables = {name: each for name, each in schema["properties"].items() if name != "name"}
    names = ", ".join(f'"{class_name(name)}"' for name in tables)
    parts = [HEAD.format(names=f'"Table", {names}')]
    parts += [table_class(name, each) for name, each in tables.items()]
    return "\n\n".join(parts)


def class_name(table: str) -> str:
    return table.title()


def table_class(name: str, declared: dict[str, Any]) -> str:
    heading = f"[[{name}]]" if declared["type"] == "array" else f"[{name}]"
    table = declared["items"] if declared["type"] == "array" else declared
    described = [paragraph(f"{key}: {meaning(key, setting, table)}") for key, setting in table["properties"].items()]
    lines = ["@dataclass(kw_only=True)", f"class {class_name(name)}(Table):",
             docstring([paragraph(f"{heading}: {table['description']}"), *described])]
    lines += [f"    {key}: {type_text(setting)} | None = None" for key, setting in table["properties"].items()]
    return "\n".join(lines) + "\n"


def meaning(key: str, setting: dict[str, Any], table: dict[str, Any]) -> str:
    text = setting["description"]
    if "x-unit" in setting:
        text += f" Unit: {setting['x-unit']}."
    if limits := range_text(setting):
        text += f" Range: {limits}."
    if key in table.get("required", []):
        text += " Required."
    elif "default" in setting:
        text += f" Default: {default_text(setting['default'])}."
    elif "x-without-it" in setting:
        text += f" Without it: {setting['x-without-it']}."
    if "x-excludes" in setting:
        text += f" Excludes {', '.join(setting['x-excludes'])}."
    return text


def default_text(value: Any) -> str:
    if isinstance(value, dict) and value.get("distribution") == "none":
        value = value["mean"]
    plain = json.loads(json.dumps(value), parse_float=lambda text: int(float(text)) if text.endswith(".0") else float(text))
    return json.dumps(plain, ensure_ascii=False)


def range_text(setting: dict[str, Any]) -> str:
    number = next((each for each in setting.get("anyOf", [setting]) if each.get("type") in ("number", "integer")), None)
    if number is None:
        return ""
    low, high = number.get("minimum"), number.get("maximum")
    above, below = number.get("exclusiveMinimum"), number.get("exclusiveMaximum")
    parts = [f"at least {low:g}" if low is not None else "", f"more than {above:g}" if above is not None else "",
             f"at most {high:g}" if high is not None else "", f"less than {below:g}" if below is not None else ""]
    return ", ".join(part for part in parts if part)


def type_text(setting: dict[str, Any]) -> str:
    if "enum" in setting:
        return f"Literal[{', '.join(json.dumps(word) for word in setting['enum'])}]"
    if "const" in setting:
        return f"Literal[{json.dumps(setting['const'])}]"
    if "anyOf" in setting:
        kinds = setting["anyOf"]
        if any(each.get("type") == "object" for each in kinds):
            return "Property"
        return " | ".join(dict.fromkeys(type_text(each) for each in kinds))
    kind = setting["type"]
    if kind == "array":
        return f"Sequence[{type_text(setting['items'])}] | np.ndarray[Any, Any]"
    if kind == "object":
        return "Mapping[Any, str]"
    if setting.get("x-file"):
        return "File"
    return {"number": "Real", "integer": "int | np.integer[Any]", "boolean": "bool", "string": "str"}[kind]


def paragraph(text: str) -> str:
    text = re.sub(r"\s+", " ", text).replace("\\", "\\\\")
    lines = textwrap.wrap(text, 112, break_long_words=False, break_on_hyphens=False)
    return "\n    ".join(lines)


def docstring(paragraphs: list[str]) -> str:
    return '    """' + "\n\n    ".join(paragraphs) + '\n    """\n'
