import csv
import io
import json
import os

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeature,
    QgsFeatureSink,
    QgsField,
    QgsFields,
    QgsGeometry,
    QgsLineString,
    QgsPointXY,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingLayerPostProcessorInterface,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QVariant

from .. import declaration, parameters, program, toml
from ..layers import attribute, crs_text
from ..results import kept, moved
from ..styles import style
from .base import Algorithm

# Keys of [design] that choose and rank lines and kits, which a single line has no use for.
OF_A_RANKING = (
    "lines",
    "protect",
    "pairs",
    "free_end_m",
    "catch_share",
    "heights_m",
    "energies_kJ",
    "cost_height_exponent",
    "cost_energy_exponent",
    "standard_file",
)


class DesignAlongLine(Algorithm):
    NAME = "designalongline"
    TITLE = "Design a barrier along a line"
    ABOUT = (
        "Asks a finished run what crosses each line of a layer, and which kit the check of a standard asks for, whole"
        " and stretch by stretch, without a new run. The stretches become a layer with the columns of design.csv. With"
        " a height and an energy, the log says what such a kit would stop. Settings of the design that are left empty"
        " are those of the run; without any, a stretch is about a twentieth of the line."
    )

    def initAlgorithm(self, configuration=None):
        self.add(
            QgsProcessingParameterFile("RESULTS", "Folder of the results", QgsProcessingParameterFile.Folder),
            "The folder that Simulate rockfall has written, with trajectories.bin, in the folder of its project file.",
        )
        self.add(
            QgsProcessingParameterFeatureSource("LINES", "Lines", [QgsProcessing.TypeVectorLine]),
            "A barrier to be designed along each; the field name names them.",
        )
        schema = self.schema()
        self.kit, self.settings = [], []
        if schema is not None:
            barrier = declaration.settings(schema, "barrier")
            self.kit = [("--height", barrier["height_m"]), ("--energy", barrier["capacity_kJ"])]
            self.settings = [
                setting for key, setting in declaration.settings(schema, "design").items() if key not in OF_A_RANKING
            ]
        for _, setting in self.kit:
            self.addParameter(parameters.parameter(setting, "Kit", advanced=False))
        for setting in self.settings:
            is_advanced = setting.key not in ("section_m", "standard")
            self.addParameter(parameters.parameter(setting, "Design", is_advanced, with_default=False))
        self.addParameter(QgsProcessingParameterFeatureSink("OUTPUT", "Stretches", QgsProcessing.TypeVectorLine))

    def options(self, values, context):
        """What the user gave, as options of `talus line`."""
        found = []
        for option, setting in self.kit:
            given = parameters.value(self, values, setting, context)
            if given is not None:
                found += [option, toml.value(given)]
        for setting in self.settings:
            given = parameters.value(self, values, setting, context)
            if given is not None:
                found += ["--design", f"{setting.key}={toml.value(given)}"]
        return found

    def processAlgorithm(self, values, context, feedback):
        results = self.path(values, "RESULTS", context)
        source = self.parameterAsSource(values, "LINES", context)
        crs = crs_of_results(results)
        transform = self.transform(source, crs, context)
        options = self.options(values, context)
        columns, sections = [], []
        total = max(source.featureCount(), 1)
        for number, feature in enumerate(source.getFeatures(), 1):
            if feedback.isCanceled():
                break
            for name, line in named_lines(feature, transform, number):
                feedback.pushInfo(f"\n{name}")
                arguments = ["line", results, "--line", " ".join(f"{point.x()!r},{point.y()!r}" for point in line)]
                feedback.pushCommandInfo(program.ask([*arguments, *options]).rstrip())
                rows = list(csv.DictReader(io.StringIO(program.ask([*arguments, *options, "--csv"]))))
                columns = columns or list(rows[0])
                sections += [(name, line, row) for row in rows if row["section"] != "all"]
            feedback.setProgress(100 * number / total)
        return {"OUTPUT": self.write(values, columns, sections, crs, context)}

    def transform(self, source, crs, context):
        name = source.sourceName()
        if source.featureCount() == 0:
            raise QgsProcessingException(f'The layer "{name}" (lines) has no features.')
        if source.sourceCrs().isValid() != crs.isValid():
            known = (
                f"is in {crs_text(source.sourceCrs())}" if source.sourceCrs().isValid() else "has no coordinate system"
            )
            other = f"are in {crs_text(crs)}" if crs.isValid() else "have no coordinate system"
            raise QgsProcessingException(
                f'The layer "{name}" (lines) {known}, while the results {other}. Give {self.named("LINES")} a layer '
                f"{'with' if crs.isValid() else 'without'} a coordinate system."
            )
        return QgsCoordinateTransform(source.sourceCrs(), crs, context.transformContext())

    def write(self, values, columns, sections, crs, context):
        fields = QgsFields()
        for column in columns:
            fields.append(QgsField(column, kind_of(column)))
        sink, identifier = self.parameterAsSink(values, "OUTPUT", context, fields, QgsWkbTypes.LineString, crs)
        if sink is None:
            raise QgsProcessingException(self.invalidSinkError(values, "OUTPUT"))
        for name, line, row in sections:
            feature = QgsFeature(fields)
            feature.setGeometry(
                QgsGeometry(QgsLineString(line).curveSubstring(float(row["from_m"]), float(row["to_m"])))
            )
            feature.setAttributes(
                [name if column == "line" else cell(row[column], kind_of(column)) for column in columns]
            )
            sink.addFeature(feature, QgsFeatureSink.FastInsert)
        if context.willLoadLayerOnCompletion(identifier):
            context.layerToLoadOnCompletionDetails(identifier).setPostProcessor(kept(Styled()))
        return identifier


class Styled(QgsProcessingLayerPostProcessorInterface):
    def postProcessLayer(self, layer, context, feedback):
        style(layer, "design")
        root = context.project().layerTreeRoot()
        moved(root.findLayer(layer.id()), root, 0)


def crs_of_results(folder):
    """The coordinate system of a run, which may be unknown."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            wkt = json.load(file)["terrain"].get("crs_wkt", "")
    except (OSError, ValueError, KeyError, AttributeError):
        raise QgsProcessingException(
            f"{folder} has no results of Talus in 3D: its summary.json is missing or of another kind."
        ) from None
    return QgsCoordinateReferenceSystem.fromWkt(wkt) if wkt else QgsCoordinateReferenceSystem()


def named_lines(feature, transform, number):
    """The parts of a line on plan in the coordinates of the results, with a name for each."""
    geometry = feature.geometry()
    if geometry.isEmpty():
        return
    if QgsWkbTypes.isCurvedType(geometry.wkbType()):
        geometry.convertToStraightSegment()
    geometry.transform(transform)
    field = next((field.name() for field in feature.fields() if field.name().lower() == "name"), None)
    name = str(attribute(feature, field) or f"line {number}")
    parts = geometry.asMultiPolyline() if geometry.isMultipart() else [geometry.asPolyline()]
    for part, line in enumerate(parts, 1):
        yield name if part == 1 else f"{name}, part {part}", [QgsPointXY(point) for point in line]


def kind_of(column):
    if column == "line":
        return QVariant.String
    return QVariant.Int if column in ("section", "rocks") or column.endswith("class") else QVariant.Double


def cell(text, kind):
    if text == "" or kind == QVariant.String:
        return text or None
    return int(text) if kind == QVariant.Int else float(text)
