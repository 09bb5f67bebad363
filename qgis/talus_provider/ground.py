"""The ground of a project from polygons of ground and of forests."""

import re

from qgis.core import QgsProcessingException, QgsWkbTypes

from .layers import VectorFile, attribute, text_field
from .toml import Written

PLAIN = re.compile(r'[\w\s=.,+"{}\[\]-]*')  # of a distribution without escapes: layers come from others
DENSITY_KEYS = ("forest", "forest_drag_kg_s")  # one or the other
FOREST_KEYS = (*DENSITY_KEYS, "forest_height_m")
KEYS_OF_TABLE = {"forest": "density", "forest_drag_kg_s": "drag_kg_s", "forest_height_m": "height_m"}


class Ground:
    """The materials of a project, and where they are. `default` has the keys of the material where nothing else is
    given, `settings` the declaration of the keys of materials."""

    def __init__(self, default, settings):
        self.settings = settings
        self.materials = {"ground": default}
        self.places = []  # pairs of a geometry and the name of its material; later ones lie over earlier ones
        self.crs = None
        self.forests = {}  # the keys of [[forest]] by its name
        self.stands = []  # as places, of forests
        self.forests_crs = None

    def tables(self, file, file_of_forests):
        found = [("[[material]]", {"name": name, **keys}) for name, keys in self.materials.items()]
        if self.places:
            found.append(("[ground]", {"default": "ground", "polygons": file, "attribute": "material"}))
        for name, keys in self.forests.items():
            chosen = {"attribute": "forest", "values": [name]} if len(self.forests) > 1 else {}
            found.append(("[[forest]]", {"name": name, "polygons": file_of_forests, **chosen, **keys}))
        return found

    def write(self, file, file_of_forests, context):
        """Writes the layers that the project needs."""
        write_polygons(file, "material", self.places, self.crs, context)
        write_polygons(file_of_forests, "forest", self.stands, self.forests_crs, context)

    def add_polygons(self, features, field):
        """Each value of `field` is a material: of the library if it is its key there, and with the values that other
        fields give by the names of keys of [[material]]."""
        self.crs = features.crs
        known = features.fields_of(key for key in self.settings if key != "name")
        problems = []
        for feature in features.source.getFeatures():
            value = attribute(feature, field)
            if value is None:
                problems.append(f'feature {feature.id()} of the layer "{features.name}" has no value in "{field}"')
                continue
            name = "ground of the layer" if str(value) == "ground" else str(value)
            keys = keys_of(feature, known, self.settings)
            if name in self.settings["like"].options:
                keys.setdefault("like", name)
            if not keys:
                problems.append(
                    f'"{name}" in "{field}" of the layer "{features.name}" is no material: it is no key of the library'
                    " (talus materials), and no field of its polygon, such as like or normal_restitution, gives its"
                    " values"
                )
            elif self.materials.setdefault(name, keys) != keys:
                problems.append(
                    f'polygons with "{name}" in "{field}" of the layer "{features.name}" have different values'
                )
            if feature.hasGeometry():
                self.places.append((feature.geometry(), name))
        if problems:
            raise QgsProcessingException("\n".join(dict.fromkeys(problems)))

    def add_forests(self, features, keys_of_all):
        """Polygons of forest, which lie over whatever ground is below: a [[forest]] for each pair of density and
        height."""
        self.forests_crs = features.crs
        known = features.fields_of(FOREST_KEYS)
        for feature in features.source.getFeatures():
            own = keys_of(feature, known, self.settings)
            has_own_density = any(key in own for key in DENSITY_KEYS)
            keys = {key: value for key, value in keys_of_all.items() if not (has_own_density and key in DENSITY_KEYS)}
            keys.update(own)
            if keys.get("forest", "none") == "none" and "forest_drag_kg_s" not in keys:
                raise QgsProcessingException(
                    f'Feature {feature.id()} of the layer "{features.name}" (forests) has no density: choose one for'
                    " all, or give the layer a field forest (open, medium or dense) or forest_drag_kg_s."
                )
            if not feature.hasGeometry():
                continue
            words = " ".join(f"{value:g}" if isinstance(value, float) else str(value) for value in keys.values())
            name = f"forest {words}"
            self.forests[name] = {KEYS_OF_TABLE[key]: value for key, value in keys.items()}
            self.stands.append((feature.geometry(), name))


def write_polygons(path, field, places, crs, context):
    if not places:
        return
    with VectorFile(path, text_field(field), QgsWkbTypes.MultiPolygon, crs, context) as file:
        for geometry, name in places:
            geometry.convertToMultiType()
            file.add(geometry, [name])


def keys_of(feature, fields, settings):
    """Keys that the fields of a feature give."""
    found = {}
    for key, field in fields.items():
        value = attribute(feature, field)
        value = as_declared(value, settings[key])
        if value is not None:
            found[key] = value
    return found


def as_declared(value, setting):
    """A value of a field for the project file: whole numbers of number fields are numbers, texts are written values."""
    if value is None:
        return None
    if setting.kind in ("choice", "text"):
        return str(value)
    if isinstance(value, (int, float)):
        return float(value) if setting.kind == "number" else value
    text = str(value)
    if text.lstrip()[:1] in ("[", "{") and ("file" in text or not PLAIN.fullmatch(text)):
        raise QgsProcessingException(
            f"{setting.title}: {text} is no number and no distribution that a layer may give. A "
            "sample in a file is named in the settings."
        )
    return Written(text)
