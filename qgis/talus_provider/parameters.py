"""Parameters of algorithms from the declaration of the settings, and their values back."""

import html

from qgis.core import (
    QgsProcessingException,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)

LARGEST_INTEGER = 2**31 - 1  # of QGIS's number boxes


def unit_text(unit):
    """ "m/s²" for m/s2, "°" for deg."""
    return unit.replace("deg", "°").replace("m2", "m²").replace("m3", "m³").replace("s2", "s²")


def description(setting, subject):
    """Subject, title and unit: "Barrier: height [m]", "Forest height [m]"."""
    unit = f" [{unit_text(setting.unit)}]" if setting.unit else ""
    title = setting.title
    if title.lower().startswith(subject.lower()):
        return title + unit
    return f"{subject}: {title[:1].lower() + title[1:] if title[1:2].islower() else title}{unit}"


def parameter(setting, subject, advanced, with_default=True):
    """A parameter of Processing. Without a value the key is left out of the project file. `with_default` shows the
    default as the value; otherwise the help tells it, as where a library may give another value."""
    text = description(setting, subject)
    default = setting.default if with_default else None
    name = setting.parameter
    if setting.kind in ("number", "integer"):
        made = number(setting, name, text, default)
    elif setting.kind == "boolean":
        made = QgsProcessingParameterBoolean(name, text, default, optional=True)
    elif setting.kind in ("choice", "choices"):
        made = QgsProcessingParameterEnum(
            name, text, list(setting.options), setting.kind == "choices", default, optional=True, usesStaticStrings=True
        )
    elif setting.kind == "file":
        made = QgsProcessingParameterFile(name, text, optional=True)
    else:
        made = QgsProcessingParameterString(name, text, default, optional=True)
    made.setHelp(html.escape(setting.help))
    if advanced:
        made.setFlags(made.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
    return made


def number(setting, name, text, default):
    whole = setting.kind == "integer"
    bounds = {}
    if setting.minimum is not None:
        bounds["minValue"] = setting.minimum
    if setting.maximum is not None:
        bounds["maxValue"] = min(setting.maximum, LARGEST_INTEGER) if whole else setting.maximum
    made = QgsProcessingParameterNumber(
        name,
        text,
        QgsProcessingParameterNumber.Integer if whole else QgsProcessingParameterNumber.Double,
        default,
        optional=True,
        **bounds,
    )
    if not whole:
        shown = max(3, decimals(default), decimals(setting.minimum))
        made.setMetadata({"widget_wrapper": {"decimals": shown}})
    return made


def decimals(number):
    """Digits behind the point, at most 6."""
    return len(f"{number or 0:.6f}".rstrip("0").partition(".")[2])


def value(algorithm, parameters, setting, context):
    """What the user gave, for the project file; None if nothing, or the default that the parameter shows."""
    name = setting.parameter
    shows_default = algorithm.parameterDefinition(name).defaultValue() is not None
    if parameters.get(name) is None and not shows_default:
        return None
    read = {
        "number": algorithm.parameterAsDouble,
        "integer": algorithm.parameterAsInt,
        "boolean": algorithm.parameterAsBoolean,
        "choice": algorithm.parameterAsEnumString,
        "choices": algorithm.parameterAsEnumStrings,
        "file": algorithm.parameterAsFile,
    }.get(setting.kind, algorithm.parameterAsString)
    try:
        return setting.to_file(read(parameters, name, context), shows_default)
    except ValueError as error:
        raise QgsProcessingException(f"{setting.title}: {error}") from None
