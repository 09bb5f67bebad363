"""Values and tables as TOML, the language of project files. No QGIS here."""

import math


def text(value):
    """A text in quotes."""
    escaped = "".join(
        {'"': '\\"', "\\": "\\\\"}.get(c, c if c >= " " and c != "\x7f" else f"\\u{ord(c):04X}") for c in value
    )
    return f'"{escaped}"'


def value(it):
    """A value of Python as TOML. Numbers keep all their digits."""
    if isinstance(it, bool):
        return "true" if it else "false"
    if isinstance(it, int):
        return str(it)
    if isinstance(it, float):
        if math.isnan(it):
            raise ValueError("a value is not a number")
        return repr(it)
    if isinstance(it, str):
        return text(it)
    if isinstance(it, Written):
        return it.toml
    return "[" + ", ".join(value(each) for each in it) + "]"


class Written:
    """A value that its user wrote: a number, a list, a distribution in braces; anything else is a text."""

    def __init__(self, written):
        written = written.strip()
        if "\n" in written or "\r" in written:
            raise ValueError(f"{written!r} has more than one line")
        try:
            float(written)
            is_number = "_" not in written
        except ValueError:
            is_number = False
        self.toml = written if is_number or written[:1] in ("[", "{") else text(written)

    def __eq__(self, other):
        return isinstance(other, Written) and self.toml == other.toml

    def __repr__(self):
        return f"Written({self.toml})"


def table(heading, values):
    """A table with its heading, such as "[terrain]"; without values it is left out."""
    if not values:
        return ""
    return "\n".join([heading] + [f"{key} = {value(it)}" for key, it in values.items()]) + "\n"


def document(first_line, name, tables):
    """A whole project file: `tables` are pairs of a heading and its values."""
    parts = [f"# {first_line}\nname = {text(name)}\n"] + [table(heading, values) for heading, values in tables]
    return "\n".join(part for part in parts if part)
