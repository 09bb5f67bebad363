"""Values as TOML text, in the layout of the workbench (web/src/toml/format.ts)."""

from __future__ import annotations

import json
import math
import os
import re
from typing import Any, Mapping

_longest_line = 110


def key_text(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else string_text(key)


def string_text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _number_text(value: float) -> str:
    if math.isnan(value):
        return "nan"
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    if value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    # As in JavaScript: a plain number from 1e-6 to 1e21, else an exponent without leading zeros.
    text = repr(value)
    mantissa, _, exponent = text.partition("e")
    if not exponent:
        return text
    power = int(exponent)
    if -7 < power < 0:
        digits = mantissa.replace("-", "").replace(".", "")
        return f"{'-' if value < 0 else ''}0.{'0' * (-power - 1)}{digits}"
    if 0 <= power < 21:
        return str(int(value))
    return f"{mantissa}e{'-' if power < 0 else '+'}{abs(power)}"


def plain(value: Any, setting: str = "") -> Any:
    """A value of Python, NumPy or this package as bool, int, float, str, list or dict.

    ``setting``: its path, for messages. Raises TypeError.
    """
    if hasattr(value, "settings") and not isinstance(value, type):
        return plain(value.settings(), setting)
    if isinstance(value, Mapping):
        return {str(key): plain(part, f"{setting}.{key}".lstrip(".")) for key, part in value.items()}
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, os.PathLike):
        return os.fsdecode(value)
    if hasattr(value, "tolist"):  # of NumPy or pandas
        listed = value.tolist()
        if not hasattr(listed, "tolist"):  # as a long double still has
            return plain(listed, setting)
    if isinstance(value, (list, tuple)):
        return [plain(part, f"{setting}.{k}") for k, part in enumerate(value)]
    raise TypeError(f"{setting or 'a setting'} cannot be {value!r}: expected a number, a text, a list or a table")


def inline_text(value: Any) -> str:
    """A plain value on one line; long lists of lists have one row per line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return string_text(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return _number_text(value)
    if isinstance(value, list):
        parts = [inline_text(part) for part in value]
        line = f"[{', '.join(parts)}]"
        if len(line) <= _longest_line or not any(isinstance(part, list) for part in value):
            return line
        return "[\n" + "".join(f"  {part},\n" for part in parts) + "]"
    parts = [pair_text(key, part) for key, part in value.items()]
    return f"{{ {', '.join(parts)} }}" if parts else "{}"


def pair_text(key: str, value: Any) -> str:
    return f"{key_text(key)} = {inline_text(value)}"


def project_text(settings: Mapping[str, Any]) -> str:
    """The text of a project file: plain keys first, then the tables in their order."""
    blocks: list[str] = []
    keys = [pair_text(key, value) for key, value in settings.items() if not _is_table(value) and not _is_list_of_tables(value)]
    if keys:
        blocks.append("\n".join(keys))
    for name, value in settings.items():
        if _is_list_of_tables(value):
            blocks += [_table_text(f"[[{key_text(name)}]]", row) for row in value]
        elif _is_table(value):
            blocks.append(_table_text(f"[{key_text(name)}]", value))
    return "\n\n".join(blocks) + "\n"


def _table_text(header: str, table: Mapping[str, Any]) -> str:
    return "\n".join([header, *(pair_text(key, value) for key, value in table.items())])


def _is_table(value: Any) -> bool:
    return isinstance(value, dict)


def _is_list_of_tables(value: Any) -> bool:
    return isinstance(value, list) and len(value) > 0 and all(isinstance(row, dict) for row in value)
