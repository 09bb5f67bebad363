"""Layers of a project of QGIS: what is refused, and files written from them."""

import os

from osgeo import gdal
from qgis.core import (
    Qgis,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeature,
    QgsField,
    QgsFields,
    QgsProcessingException,
    QgsRasterBlockFeedback,
    QgsRasterDataProvider,
    QgsRasterFileWriter,
    QgsRasterPipe,
    QgsUnitTypes,
    QgsVectorFileWriter,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QVariant


def crs_text(crs):
    return crs.authid() or crs.description() or "a coordinate system of its own"


class Terrain:
    """The DEM, as it is when an algorithm is prepared (in QGIS's own thread)."""

    def __init__(self, layer, crs_if_unknown, crs_parameter):
        self.name = layer.name()
        self.crs_if_unknown = crs_if_unknown
        self.crs_parameter = crs_parameter
        self.provider = layer.dataProvider().clone()
        self.crs = QgsCoordinateReferenceSystem(layer.crs())
        self.is_local = not self.crs.isValid() and crs_if_unknown == "local"
        self.has_two = self.crs.isValid() and bool(crs_if_unknown)
        if not self.crs.isValid() and not self.is_local:
            self.crs = QgsCoordinateReferenceSystem(crs_if_unknown)
        self.file = layer.dataProvider().dataSourceUri()

    def problems(self):
        if self.has_two:
            yield (
                f'The DEM "{self.name}" is in {crs_text(self.crs)}, so that '
                f"{self.crs_parameter} has no effect. Leave it empty."
            )
        if not self.crs.isValid():
            if self.crs_if_unknown and not self.is_local:
                yield (
                    f'The DEM "{self.name}" has no coordinate system, and {self.crs_parameter} is '
                    f'"{self.crs_if_unknown}", which QGIS does not know. Give a code such as EPSG:25832, or local.'
                )
            elif not self.is_local:
                yield (
                    f'The DEM "{self.name}" has no coordinate system. Set it in the properties of the layer, or by '
                    f"{self.crs_parameter}: a code such as EPSG:25832, or local if the coordinates are metres without a"
                    " map."
                )
        elif self.crs.isGeographic():
            yield (
                f'The DEM "{self.name}" is in degrees ({crs_text(self.crs)}). Talus computes in metres: reproject it '
                "first, with Raster > Projections > Warp (Reproject), to a projected system such as UTM."
            )
        elif self.crs.mapUnits() != QgsUnitTypes.DistanceMeters:
            units = QgsUnitTypes.toString(self.crs.mapUnits())
            yield (
                f'The DEM "{self.name}" is in {units} ({crs_text(self.crs)}). Talus computes in metres: reproject it to'
                " a system in metres."
            )
        if not self.provider.capabilities() & QgsRasterDataProvider.Size or self.provider.dataType(1) in (
            Qgis.ARGB32,
            Qgis.ARGB32_Premultiplied,
        ):
            yield (
                f'The DEM "{self.name}" is a picture, not a grid of elevations. Download its elevations first (WCS,'
                " GeoTIFF)."
            )
        if self.provider.userNoDataValues(1):
            yield (
                f'The DEM "{self.name}" hides values by an additional no data value in its properties. Save it first,'
                " with Export > Save As and its No data values, so that its file declares them."
            )

    def write(self, path, context, feedback):
        """All its cells with their own values, as a GeoTIFF in the coordinate system that the layer shows."""
        pipe = QgsRasterPipe()
        pipe.set(self.provider.clone())
        writer = QgsRasterFileWriter(path)
        writer.setOutputFormat("GTiff")
        block_feedback = QgsRasterBlockFeedback()
        feedback.canceled.connect(block_feedback.cancel)
        error = writer.writeRaster(
            pipe,
            self.provider.xSize(),
            self.provider.ySize(),
            self.provider.extent(),
            self.crs,
            context.transformContext(),
            block_feedback,
        )
        if error not in (QgsRasterFileWriter.NoError, QgsRasterFileWriter.WriteCanceled):
            raise QgsProcessingException(f'The DEM "{self.name}" could not be written to {path} (error {int(error)}).')


class Features:
    """The features of a vector layer that an algorithm is given: the selected ones, or all, as the layer shows them.
    What concerns the layer itself is read at once, in QGIS's own thread."""

    def __init__(self, purpose, parameter, source, layer, terrain, context):
        self.purpose = purpose
        self.parameter = parameter
        self.source = source
        self.is_edited = layer is not None and layer.isEditable() and layer.isModified()
        self.is_selection = layer is not None and source.featureCount() < layer.featureCount()
        self.file = layer.dataProvider().dataSourceUri() if layer is not None else ""
        self.terrain = terrain
        self.context = context
        self.crs = source.sourceCrs()
        self.name = source.sourceName()

    def to_terrain(self):
        """The transform to the coordinate system of the terrain; of no effect if both are unknown."""
        return QgsCoordinateTransform(self.crs, self.terrain.crs, self.context.transformContext())

    def problems(self):
        layer = f'The layer "{self.name}" ({self.purpose})'
        if self.source.featureCount() == 0:
            yield f"{layer} has no {'selected ' if self.is_selection else ''}features."
            return
        if not self.crs.isValid():
            if self.terrain.crs.isValid():
                yield (
                    f"{layer} has no coordinate system, while the DEM is in {crs_text(self.terrain.crs)}. Set it in the"
                    f" properties of the layer, or give {self.parameter} a file with a coordinate system (ogr2ogr"
                    " -a_srs writes one)."
                )
        elif self.terrain.is_local:
            yield (
                f"{layer} is in {crs_text(self.crs)}, while the DEM has no coordinate system, so that it is not known "
                f"where it lies. Give {self.terrain.crs_parameter} the coordinate system of the DEM instead of local, "
                f"or give {self.parameter} a layer without one."
            )
        yield from self.problems_of_place(layer)

    def problems_of_place(self, layer):
        if self.crs.isValid() != self.terrain.crs.isValid():
            return
        try:
            extent = self.to_terrain().transformBoundingBox(self.source.sourceExtent())
        except QgsCsException as error:
            yield f"{layer} could not be transformed from {crs_text(self.crs)} to {crs_text(self.terrain.crs)}: {error}"
            return
        if not extent.intersects(self.terrain.provider.extent()):
            yield (
                f"{layer} lies elsewhere than the DEM: its extent in the coordinates of the DEM is "
                f"{extent.toString(0)}, that of the DEM {self.terrain.provider.extent().toString(0)}. "
                "Check the coordinate systems of both layers."
            )

    def notes(self):
        if self.is_edited:
            yield (
                f'The layer "{self.name}" has edits that are not saved; they are part of this project as the layer'
                " shows them."
            )
        if self.crs.isValid() and self.crs != self.terrain.crs:
            yield f'The layer "{self.name}" is transformed from {crs_text(self.crs)} to {crs_text(self.terrain.crs)}.'

    def fields_of(self, keys):
        """The layer's fields with the names of keys, whatever their case, by key."""
        fields = {field.name().lower(): field.name() for field in self.source.fields()}
        return {key: fields[key.lower()] for key in keys if key.lower() in fields}


def attribute(feature, field):
    """A value of a feature; None for NULL and for an empty text."""
    value = feature[field] if field else None
    if isinstance(value, QVariant):
        value = None if value.isNull() else value.value()
    return None if isinstance(value, str) and not value.strip() else value


class VectorFile:
    """A GeoPackage with one layer, written feature by feature in a `with` statement. The same layer gives the same bytes:
    the time of the last change is 1970, as in the GeoPackages of the program."""

    def __init__(self, path, fields, geometry_type, crs, context):
        options = QgsVectorFileWriter.SaveVectorOptions()
        options.driverName = "GPKG"
        options.layerName = os.path.splitext(os.path.basename(path))[0]
        self.path = path
        self.fields = fields
        gdal.SetThreadLocalConfigOption("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z")
        self.writer = QgsVectorFileWriter.create(path, fields, geometry_type, crs, context.transformContext(), options)
        self.check()

    def check(self):
        if self.writer.hasError() != QgsVectorFileWriter.NoError:
            raise QgsProcessingException(f"{self.path} could not be written: {self.writer.errorMessage()}")

    def add(self, geometry, attributes):
        feature = QgsFeature(self.fields)
        feature.setGeometry(geometry)
        feature.setAttributes(attributes)
        if not self.writer.addFeature(feature):
            self.check()
            raise QgsProcessingException(f"{self.path} could not be written")

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        try:
            if error is None:
                self.writer.flushBuffer()
                self.check()
        finally:
            del self.writer
            gdal.SetThreadLocalConfigOption("OGR_CURRENT_DATE", None)


def text_field(name):
    fields = QgsFields()
    fields.append(QgsField(name, QVariant.String))
    return fields


def write_features(features, path, field_names, context, feedback):
    """The features of a layer with some of its fields."""
    fields = QgsFields()
    for name in field_names:
        fields.append(features.source.fields().field(name))
    with VectorFile(path, fields, features.source.wkbType(), features.crs, context) as file:
        for feature in features.source.getFeatures():
            if feedback.isCanceled():
                break
            file.add(feature.geometry(), [feature[name] for name in field_names])


def lines_on_plan(features):
    """Each feature with its lines on plan, [[x, y], ...] in the terrain's coordinates; curves as short chords."""
    transform = features.to_terrain()
    for feature in features.source.getFeatures():
        if not feature.hasGeometry():
            continue
        geometry = feature.geometry()
        if QgsWkbTypes.isCurvedType(geometry.wkbType()):
            geometry.convertToStraightSegment()
        geometry.transform(transform)
        for line in geometry.asMultiPolyline() if geometry.isMultipart() else [geometry.asPolyline()]:
            yield feature, [[point.x(), point.y()] for point in line]
