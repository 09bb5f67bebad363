"""Settings as keyword arguments: ``material={"Scree": {"normal_restitution": 0.3}}``."""

from __future__ import annotations

from functools import lru_cache
import json
from typing import Any, Mapping

from . import _talus
from .problems import BadInput, unicode_text
from .toml_text import inline_text, key_text, plain


def schema() -> dict[str, Any]:
    """The JSON Schema of the project file: every table and key with its unit, range, default and meaning."""
    return json.loads(_talus.schema_text())


@lru_cache(maxsize=1)
def declared() -> dict[str, Any]:
    """The tables of the schema, not to be changed."""
    return schema()["properties"]


def limits(table: str, key: str) -> tuple[float, float]:
    """The least and the greatest number that a setting may have."""
    setting = declared()[table].get("items", declared()[table])["properties"][key]
    number = next(kind for kind in setting.get("anyOf", [setting]) if kind.get("type") == "number")
    return number["minimum"], number["maximum"]


def overrides(settings: Mapping[str, Any]) -> list[str]:
    """The settings as the program's option ``--set`` takes them.

    A key may be the path of a setting as well: ``{"material.Scree.normal_restitution": 0.3}``.
    """
    out: list[str] = []
    for name, value in settings.items():
        value = plain(value, name)
        table = declared().get(name)
        if not isinstance(value, dict) or table is None:
            out.append(f"{name}={inline_text(value)}")
        elif table["type"] == "array":
            for row, values in value.items():
                if not isinstance(values, dict) or not values:
                    raise BadInput(f'{name}={{"{row}": {values!r}}}: expected a table of settings. '
                                   f'For example {name}={{"{row}": {{...}}}}')
                out += [f"{name}.{key_text(row)}.{key_text(key)}={inline_text(each)}" for key, each in values.items()]
        else:
            out += [f"{name}.{key_text(key)}={inline_text(each)}" for key, each in value.items()]
    return [unicode_text(name, each) for each in out]


def whole_or_none(name: str, value: Any, least: int = 0) -> int | None:
    return None if value is None else whole(name, value, least)


def whole(name: str, value: Any, least: int = 0) -> int:
    """A whole number."""
    number = value.item() if hasattr(value, "item") and getattr(value, "size", 1) == 1 else value
    if isinstance(number, bool) or not isinstance(number, int) or not least <= number < 2**63:
        raise BadInput(f"{name}={value!r}: expected a whole number, at least {least}")
    return number
