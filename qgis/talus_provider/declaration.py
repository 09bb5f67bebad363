"""The settings of a project as the program declares them (`talus schema`). No QGIS here."""

from dataclasses import dataclass
from typing import Any, Optional

from . import toml


@dataclass(frozen=True)
class Setting:
    """One key of a table. `kind` is number, integer, boolean, choice, choices, file, text, or written: a value in the
    form of the project file, such as a number, a distribution or a list."""

    table: str
    key: str
    kind: str
    help: str
    unit: str
    title: str
    default: Any = None
    minimum: Optional[float] = None
    maximum: Optional[float] = None
    options: tuple = ()

    @property
    def parameter(self):
        return f"{self.table}_{self.key}".upper()

    def to_file(self, value, without_default=True):
        """The value for the project file; None if there is none, or if it is the default, which is then left out."""
        if value is None or value == "" or (without_default and value == self.default):
            return None
        return toml.Written(value) if self.kind == "written" else value


def title_of(key, unit):
    """The key without its unit: "Forest height" for forest_height_m."""
    ending = "_" + unit.replace("1/", "per_").replace("/", "_")
    bare = key[: -len(ending)] if unit and key.endswith(ending) else key
    return bare[:1].upper() + bare[1:].replace("_", " ")


def kind_of(declared):
    if "enum" in declared:
        return "choice"
    if declared.get("type") in ("number", "integer", "boolean"):
        return declared["type"]
    if declared.get("type") == "string":
        return "file" if declared.get("x-file") else "text"
    if any("enum" in form.get("items", {}) for form in declared.get("anyOf", ())):
        return "choices"
    return "written"


def written_default(default):
    """A default in the form in which a user writes it."""
    if isinstance(default, dict):  # a distribution without a spread
        return written_default(default["mean"])
    if isinstance(default, float):
        return f"{default:.15g}"
    if isinstance(default, list):
        return "[" + ", ".join(written_default(each) for each in default) + "]"
    return None if default is None else str(default)


def help_of(declared, minimum, maximum, default):
    parts = [declared["description"]]
    bounds = [f"{bound:.15g}" for bound in (minimum, maximum) if bound is not None]
    if len(bounds) == 2:
        parts.append(f"Range: {bounds[0]} to {bounds[1]}.")
    if "x-without-it" in declared:
        parts.append(f"Without it: {declared['x-without-it']}.")
    elif default is not None:
        parts.append(f"Default: {written_default(default)}.")
    return " ".join(parts)


def range_of(declared):
    ranges = [declared] + declared.get("anyOf", [])
    for form in ranges:
        if "mean" in form.get("properties", {}):
            ranges.append(form["properties"]["mean"])
    low = next((r[k] for r in ranges for k in ("minimum", "exclusiveMinimum") if k in r), None)
    high = next((r[k] for r in ranges for k in ("maximum", "exclusiveMaximum") if k in r), None)
    return low, high


def setting(table, key, declared):
    kind = kind_of(declared)
    default = declared.get("default")
    minimum, maximum = range_of(declared)
    options = declared.get("enum", ())
    if kind == "choices":
        options = next(form["items"]["enum"] for form in declared["anyOf"] if "items" in form)
    unit = declared.get("x-unit", "")
    help_text = help_of(declared, minimum, maximum, default)
    if kind == "choices" and default is True:
        default = list(options)
    if kind == "written":
        default = written_default(default)
    return Setting(
        table,
        key,
        kind,
        help_text,
        unit,
        declared.get("x-title") or title_of(key, unit),
        default,
        minimum,
        maximum,
        tuple(options),
    )


def settings(schema, table):
    """All settings of a table, or of an entry of a list of tables, by their keys."""
    declared = schema["properties"][table]
    entry = declared.get("items", declared)
    return {key: setting(table, key, value) for key, value in entry["properties"].items()}
