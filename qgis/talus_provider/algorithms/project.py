"""What simulating and checking have in common: parameters that are layers and settings, made into a project file."""

import os
import re
import shutil

from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingOutputFile,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProcessingUtils,
    QgsVectorLayer,
    QgsWkbTypes,
)

from .. import declaration, parameters, toml
from ..ground import FOREST_KEYS, Ground, keys_of
from ..layers import Features, Terrain, lines_on_plan, write_features
from .base import Algorithm

FIRST_LINE = "Written by the QGIS plugin of Talus from layers. To run it again: talus run "

RELEASE_KEYS = (
    "rocks",
    "rocks_per_cell",
    "min_slope_deg",
    "height_above_m",
    "diameter_m",
    "mass_kg",
    "volume_m3",
    "density_kg_m3",
    "max_slope_deg",
    "place",
    "horizontal_velocity_m_s",
    "vertical_velocity_m_s",
    "speed_m_s",
    "rotational_velocity_deg_s",
    "direction",
)
# The tables of which all keys can be set, less what a layer or a point on the map gives.
WHOLE_TABLES = {"analysis": (), "sampling": (), "output": ("runout_from", "runout_along")}
# Settings beside the layers; all others are advanced.
FIRST_SEEN = {
    "RELEASE": (
        "seeder.rocks",
        "seeder.rocks_per_cell",
        "seeder.min_slope_deg",
        "seeder.height_above_m",
        "seeder.diameter_m",
        "analysis.model",
        "material.like",
    ),
    "GROUND": (),
    "FORESTS": ("material.forest", "material.forest_height_m"),
    "BARRIERS": ("barrier.height_m", "barrier.capacity_kJ"),
    "COLLECTORS": ("collector.height_m",),
}

# The type of the seeder, and the key that names its file.
SEEDERS = {
    QgsWkbTypes.PolygonGeometry: ("polygon", "polygons"),
    QgsWkbTypes.LineGeometry: ("line", "lines"),
    QgsWkbTypes.PointGeometry: ("table", "table"),
}

LAYERS = (
    # parameter, what it is for, description, kinds of geometry, help
    (
        "RELEASE",
        "release",
        "Release areas, lines or points",
        [QgsProcessing.TypeVectorAnyGeometry],
        (
            "Rocks start from the cells within polygons, along lines, or at points, whose fields may give the velocity"
            " and the mass of each rock. Without a layer they start from all cells above the minimum slope."
        ),
    ),
    (
        "GROUND",
        "ground",
        "Ground polygons",
        [QgsProcessing.TypeVectorPolygon],
        "Parts of the terrain with other materials.",
    ),
    (
        "FORESTS",
        "forests",
        "Forest polygons",
        [QgsProcessing.TypeVectorPolygon],
        (
            "Forests slow rocks below their height. Fields forest (open, medium, dense), forest_height_m and"
            " forest_drag_kg_s give the values of each polygon."
        ),
    ),
    (
        "BARRIERS",
        "barriers",
        "Barriers",
        [QgsProcessing.TypeVectorLine],
        (
            "Lines of fences, nets, walls or dams. Fields with the names of keys, such as name, height_m and"
            " capacity_kJ, give the values of each line."
        ),
    ),
    (
        "COLLECTORS",
        "collectors",
        "Collectors",
        [QgsProcessing.TypeVectorLine],
        "Lines that record the rocks which cross them. Fields name and height_m give the values of each line.",
    ),
    (
        "RUNOUT",
        "runout",
        "Output: line along which runout is counted",
        [QgsProcessing.TypeVectorLine],
        (
            "One line: runout is the distance along it on plan, from its first point. The line goes on straight beyond"
            " its ends. Without it runout is counted from each rock's release."
        ),
    ),
)
FIELDS = {
    "RELEASE": (
        "SOURCE_FIELD",
        "Field with the source of the rocks",
        "For results split by source, such as the name of the cliff.",
    ),
    "GROUND": (
        "GROUND_FIELD",
        "Field with the material of the ground",
        (
            "Each value is a material: a key of the library (talus materials), or a name of your own, whose values are"
            " in fields with the names of keys, such as like, normal_restitution or friction_angle_deg."
        ),
    ),
}


class ProjectAlgorithm(Algorithm):
    """An algorithm that writes layers and a project file into a folder."""

    def initAlgorithm(self, configuration=None):
        self.add(
            QgsProcessingParameterRasterLayer("DEM", "DEM: elevations in metres"),
            "A raster of elevations (its first band), in a projected coordinate system in metres.",
        )
        self.settings = self.declared_settings()
        for name, _, description, kinds, help_text in LAYERS:
            layer = QgsProcessingParameterFeatureSource(name, description, kinds, optional=True)
            if name not in FIRST_SEEN:
                layer.setFlags(layer.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
            self.add(layer, help_text)
            if name in FIELDS:
                field, description, help_text = FIELDS[name]
                self.add(
                    QgsProcessingParameterField(field, description, parentLayerParameterName=name, optional=True),
                    help_text,
                )
            self.add_settings(lambda key, of=FIRST_SEEN.get(name, ()): key in of, advanced=False)
        self.add(
            QgsProcessingParameterString("NAME", "Name of the project", "rockfall"),
            "Names the project file and the folder of the results.",
        )
        self.add(
            QgsProcessingParameterFolderDestination("OUTPUT", "Folder of the project"),
            (
                "Receives the project file with the layers that it uses, and the results. The program can run it again:"
                " talus run NAME.toml"
            ),
        )
        self.add_settings(lambda key: not any(key in keys for keys in FIRST_SEEN.values()), advanced=True)
        point = QgsProcessingParameterPoint(
            "OUTPUT_RUNOUT_FROM", "Output: point from which runout is counted", optional=True
        )
        point.setFlags(point.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
        self.add(point, "Runout is the distance on plan from here. Without it it is counted from each rock's release.")
        self.addOutput(QgsProcessingOutputFile("PROJECT_FILE", "Project file"))

    def add_settings(self, are_wanted, advanced):
        for setting, subject in self.settings:
            if are_wanted(f"{setting.table}.{setting.key}"):
                self.addParameter(parameters.parameter(setting, subject, advanced, setting.table != "material"))

    def declared_settings(self):
        """Pairs of a setting and what it is about."""
        schema = self.schema()
        if schema is None:
            return []
        tables = {
            name: declaration.settings(schema, name)
            for name in ("terrain", "seeder", "material", "barrier", "collector", *WHOLE_TABLES)
        }
        self.tables = tables
        found = [(tables["seeder"][key], "Release") for key in RELEASE_KEYS]
        found += [
            (setting, "Ground")
            for key, setting in tables["material"].items()
            if key != "name" and key not in FOREST_KEYS
        ]
        found += [(tables["material"][key], "Forest") for key in FOREST_KEYS]
        for table, subject in (("barrier", "Barrier"), ("collector", "Collector")):
            found += [(setting, subject) for key, setting in tables[table].items() if key not in ("name", "line")]
        found.append((tables["terrain"]["crs"], "Terrain"))
        for table, left_out in WHOLE_TABLES.items():
            found += [(setting, table.capitalize()) for key, setting in tables[table].items() if key not in left_out]
        return found

    def prepareAlgorithm(self, values, context, feedback):
        layer = self.parameterAsRasterLayer(values, "DEM", context)
        if layer is None or not layer.isValid():
            raise QgsProcessingException("The layer of the DEM could not be read.")
        crs = self.parameterAsString(values, "TERRAIN_CRS", context).strip()
        self.terrain = Terrain(layer, crs, self.named("TERRAIN_CRS"))
        self.chosen = self.features(values, context)
        return True

    def keys(self, values, table, context):
        """The keys of a table that the user gave."""
        given = {
            setting.key: parameters.value(self, values, setting, context)
            for setting, _ in self.settings
            if setting.table == table
        }
        return {key: value for key, value in given.items() if value is not None}

    def features(self, values, context):
        """The layers that were chosen, by the names of their parameters."""
        found = {}
        for name, purpose, *_ in LAYERS:
            if values.get(name) is None or values.get(name) == "":
                continue
            source = self.parameterAsSource(values, name, context)
            if source is None:
                raise QgsProcessingException(self.invalidSourceError(values, name))
            found[name] = Features(
                purpose, self.named(name), source, layer_of(values[name], context), self.terrain, context
            )
        return found

    def write_project(self, values, context, feedback):
        """Writes the project file and its layers, and returns its path."""
        name = self.parameterAsString(values, "NAME", context).strip()
        folder = self.path(values, "OUTPUT", context)
        if not re.fullmatch(r"\w[\w .-]*", name):
            raise QgsProcessingException(
                f'"{name}" is no name of a project: use letters, digits, spaces, points, hyphens.'
            )
        chosen = self.chosen
        project = os.path.join(folder, name + ".toml")
        problems = list(self.terrain.problems())
        for features in chosen.values():
            problems += features.problems()
        problems += self.overwritten(project, folder, name, chosen)
        if problems:
            raise QgsProcessingException("\n".join(problems))
        for features in chosen.values():
            for note in features.notes():
                feedback.pushInfo(note)
        os.makedirs(folder, exist_ok=True)
        self.terrain.write(os.path.join(folder, f"{name}-terrain.tif"), context, feedback)
        tables = [
            ("[terrain]", {"raster": f"{name}-terrain.tif", **({"crs": "local"} if self.terrain.is_local else {})})
        ]
        tables += self.ground(values, chosen, folder, name, context)
        tables.append(("[[seeder]]", self.seeder(values, chosen.get("RELEASE"), folder, name, context, feedback)))
        tables += self.lines(values, chosen, context)
        for table in WHOLE_TABLES:
            keys = self.with_files(self.keys(values, table, context), table, folder)
            if table == "output":
                keys.update(self.runout(values, chosen.get("RUNOUT"), context))
            tables.append((f"[{table}]", keys))
        try:
            text = toml.document(FIRST_LINE + os.path.basename(project), name, tables)
        except ValueError as error:
            raise QgsProcessingException(str(error)) from None
        with open(project, "w", encoding="utf-8") as file:
            file.write(text)
        return project

    def overwritten(self, project, folder, name, chosen):
        """Problems with files that exist and are not to be lost."""
        if os.path.exists(project):
            with open(project, encoding="utf-8", errors="replace") as file:
                if not file.readline().startswith("# " + FIRST_LINE):
                    yield f"{project} exists and was not written by this plugin. Choose another name or folder."
        ours = {
            os.path.realpath(os.path.join(folder, name + ending))
            for ending in ("-terrain.tif", "-release.gpkg", "-ground.gpkg", "-forest.gpkg")
        }
        for layer in (self.terrain, *chosen.values()):
            file = layer.file.split("|")[0]
            if os.path.realpath(file) in ours:
                yield f'The layer "{layer.name}" is {file}, which would be overwritten. Choose another name or folder.'

    def ground(self, values, chosen, folder, name, context):
        given = self.keys(values, "material", context)
        forest = {key: given.pop(key) for key in FOREST_KEYS if key in given}
        if forest.get("forest") == "none":
            del forest["forest"]
        ground = Ground(given, self.tables["material"])
        if "GROUND" in chosen:
            field = self.parameterAsString(values, "GROUND_FIELD", context)
            if not field:
                raise QgsProcessingException("Choose the field of the ground polygons that names their material.")
            ground.add_polygons(chosen["GROUND"], field)
        if "FORESTS" in chosen:
            ground.add_forests(chosen["FORESTS"], forest)
        elif forest:
            raise QgsProcessingException("Forests have values but no polygons. Choose the layer of the forests.")
        files = (f"{name}-ground.gpkg", f"{name}-forest.gpkg")
        ground.write(*(os.path.join(folder, file) for file in files), context)
        return ground.tables(*files)

    def seeder(self, values, features, folder, name, context, feedback):
        given = self.keys(values, "seeder", context)
        if features is None:
            if "min_slope_deg" not in given:
                raise QgsProcessingException(
                    "Choose a layer from which rocks start, or a minimum slope of the cells from which they start."
                )
            return {"type": "raster", **given}
        geometry_type = QgsWkbTypes.geometryType(features.source.wkbType())
        if geometry_type not in SEEDERS:
            raise QgsProcessingException(
                f'The layer "{features.name}" (release) has geometries of several kinds: choose one '
                "with polygons, lines or points alone."
            )
        kind, key = SEEDERS[geometry_type]
        source = self.parameterAsString(values, "SOURCE_FIELD", context)
        fields = [source] if source else []
        if kind == "table":
            fields = [field.name() for field in features.source.fields() if field.name().lower() != "fid"]
        write_features(features, os.path.join(folder, f"{name}-release.gpkg"), fields, context, feedback)
        return {"type": kind, key: f"{name}-release.gpkg", **({"source_attribute": source} if source else {}), **given}

    def lines(self, values, chosen, context):
        """A table for each line of barriers and collectors."""
        tables, names = [], set()
        for layer, table in (("BARRIERS", "barrier"), ("COLLECTORS", "collector")):
            if layer not in chosen:
                continue
            features, settings = chosen[layer], self.tables[table]
            of_all = self.keys(values, table, context)
            known = features.fields_of(key for key in settings if key != "line")
            for feature, line in lines_on_plan(features):
                keys = {**of_all, **keys_of(feature, known, settings)}
                wanted = str(keys.pop("name", f"{table} {len(tables) + 1}"))
                unique = next(each for each in numbered(wanted) if each not in names)
                names.add(unique)
                tables.append((f"[[{table}]]", {"name": unique, "line": line, **keys}))
        return tables

    def runout(self, values, features, context):
        """From where runout is counted: keys of the table output."""
        found = {}
        if values.get("OUTPUT_RUNOUT_FROM") not in (None, ""):
            point = self.parameterAsPoint(values, "OUTPUT_RUNOUT_FROM", context, self.terrain.crs)
            found["runout_from"] = [point.x(), point.y()]
        if features is not None:
            lines = [line for _, line in lines_on_plan(features)]
            if len(lines) != 1:
                raise QgsProcessingException(
                    f'The layer "{features.name}" (runout) has {len(lines)} lines, and runout is counted along one. '
                    "Select it, and tick Selected features only."
                )
            found["runout_along"] = lines[0]
        return found

    def with_files(self, keys, table, folder):
        """Files that settings name, copied beside the project file."""
        for key, value in keys.items():
            if self.tables[table][key].kind == "file":
                if not os.path.isfile(value):
                    raise QgsProcessingException(f"{self.tables[table][key].title}: there is no file {value}.")
                copy = os.path.join(folder, os.path.basename(value))
                if os.path.realpath(copy) != os.path.realpath(value):
                    shutil.copyfile(value, copy)
                keys[key] = os.path.basename(value)
        return keys


def layer_of(value, context):
    """The layer of a source, which may be limited to the selected features; None if it is not a layer of its own."""
    if isinstance(value, QgsProcessingFeatureSourceDefinition):
        value = value.source.staticValue()
    layer = QgsProcessingUtils.mapLayerFromString(value, context) if isinstance(value, str) else value
    return layer if isinstance(layer, QgsVectorLayer) else None


def numbered(name):
    """name, name 2, name 3, ..."""
    yield name
    number = 2
    while True:
        yield f"{name} {number}"
        number += 1
