"""How the layers of results look. Energies have the classes and colours of the maps of the program."""

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsGraduatedSymbolRenderer,
    QgsLineSymbol,
    QgsMarkerSymbol,
    QgsPalLayerSettings,
    QgsRendererCategory,
    QgsRendererRange,
    QgsSingleSymbolRenderer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayerSimpleLabeling,
)

ENERGIES_KJ = (0, 30, 100, 300, 1000, 3000, float("inf"))
COLOURS = ("#ffffb2", "#fed670", "#fda63f", "#f0702c", "#c8281e", "#800026")
ENDS = {"at rest": "#333333", "stopped by a barrier": "#1a9850", "left the model": "#3288bd", "no data": "#984ea3"}
KIT_CLASSES = (  # ColorBrewer YlGnBu, which differs from the colours of energies
    "#ffffd9",
    "#edf8b1",
    "#c7e9b4",
    "#7fcdbb",
    "#41b6c4",
    "#1d91c0",
    "#225ea8",
    "#253494",
    "#081d58",
)


def line(colour, width, **more):
    return QgsLineSymbol.createSimple({"line_color": colour, "line_width": str(width), "capstyle": "round", **more})


def dot(colour, size, outline="no"):
    return QgsMarkerSymbol.createSimple(
        {"color": colour, "size": str(size), "outline_style": outline, "outline_width": "0.2"}
    )


def labelled(layer, expression):
    settings = QgsPalLayerSettings()
    settings.fieldName = expression
    settings.isExpression = True
    settings.placement = QgsPalLayerSettings.Line
    text, halo = QgsTextFormat(), QgsTextBufferSettings()
    halo.setEnabled(True)
    halo.setSize(0.8)
    text.setBuffer(halo)
    text.setSize(8)
    settings.setFormat(text)
    layer.setLabeling(QgsVectorLayerSimpleLabeling(settings))
    layer.setLabelsEnabled(True)


def style_paths(layer):
    ranges = []
    for low, high, colour in zip(ENERGIES_KJ, ENERGIES_KJ[1:], COLOURS):
        label = f"{low} kJ and more" if high == float("inf") else f"{low} to {high} kJ"
        ranges.append(QgsRendererRange(low, high, line(colour, 0.15), label))
    layer.setRenderer(QgsGraduatedSymbolRenderer('"max_ke_J" / 1000', ranges))
    layer.setOpacity(0.8)


def style_endpoints(layer):
    categories = [QgsRendererCategory(end, dot(colour, 1.2), end) for end, colour in ENDS.items()]
    categories.append(QgsRendererCategory(None, dot("#e7298a", 1.2), "for another reason"))
    layer.setRenderer(QgsCategorizedSymbolRenderer("end_reason", categories))


def style_releases(layer):
    layer.setRenderer(QgsSingleSymbolRenderer(dot("#ffffff", 1.2, "solid")))


def style_impacts(layer):
    layer.setRenderer(QgsSingleSymbolRenderer(dot("#7570b3", 0.6)))


def style_barriers(layer):
    layer.setRenderer(
        QgsCategorizedSymbolRenderer(
            "kind",
            [
                QgsRendererCategory("barrier", line("#000000", 1.0), "barrier"),
                QgsRendererCategory("collector", line("#762a83", 0.7, line_style="dash"), "collector"),
            ],
        )
    )
    labelled(layer, '"name"')


def style_design(layer):
    """The sections of lines by the class of kit that each asks for (EAD 340059-00-0106)."""
    categories = [
        QgsRendererCategory(number, line(colour, 1.8), f"asks for class {number}")
        for number, colour in enumerate(KIT_CLASSES)
    ]
    categories.append(QgsRendererCategory(None, line("#999999", 1.0), "no rocks"))
    layer.setRenderer(QgsCategorizedSymbolRenderer("needs_class", categories))


STYLES = {
    "paths": style_paths,
    "endpoints": style_endpoints,
    "releases": style_releases,
    "impacts": style_impacts,
    "barriers": style_barriers,
    "design": style_design,
}


def style(layer, kind):
    if kind in STYLES:
        STYLES[kind](layer)
        layer.triggerRepaint()
