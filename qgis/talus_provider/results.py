"""Results of a run as layers in a group."""

import json
import sqlite3
import uuid
from contextlib import closing
from pathlib import Path

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingLayerPostProcessorInterface,
    QgsProcessingUtils,
)
from qgis.PyQt import sip

from .styles import style

# The layers of results.gpkg from the top, with their titles and whether they are shown at first.
TABLES = {
    "barriers": ("Barriers and collectors", True),
    "design": ("Design", True),
    "endpoints": ("End points", False),
    "releases": ("Releases", False),
    "impacts": ("Impacts", False),
    "paths": ("Trajectories", False),
}
FIRST_MAPS = ("reach_share", "energy_total_p95_kJ", "velocity_p95_m_s", "bounce_height_p95_m", "deposits")
SHOWN_MAP = "reach_share"
UNITS = {"_kJ": "kJ", "_m_s": "m/s", "_m": "m"}
LOAD, ORDER = "talus/load", "talus/order"  # custom properties of groups and nodes
KEPT = []  # what QGIS is still to call: it holds the objects, but not their Python side


def kept(processor):
    KEPT[:] = [each for each in KEPT if not sip.isdeleted(each)] + [processor]
    return processor


class Entry(QgsProcessingLayerPostProcessorInterface):
    """A layer to load, which then gets its style and its place."""

    def __init__(self, load, group, subgroup, order, source, title, kind, shown):
        super().__init__()
        self.load, self.group, self.subgroup, self.order = load, group, subgroup, order
        self.source, self.title, self.kind, self.shown = source, title, kind, shown

    def postProcessLayer(self, layer, context, feedback):
        if self.kind == "map":
            layer.loadDefaultStyle()  # the one that the run has written beside it
        else:
            style(layer, self.kind)
        root = context.project().layerTreeRoot()
        home = self.home(root)
        node = moved(root.findLayer(layer.id()), home, place(home, self.order))
        node.setCustomProperty(ORDER, self.order)
        node.setItemVisibilityChecked(self.shown)
        node.setExpanded(self.shown)

    def home(self, root):
        group = next((each for each in root.findGroups() if each.customProperty(LOAD) == self.load), None)
        if group is None:
            group = root.insertGroup(0, self.group)
            group.setCustomProperty(LOAD, self.load)
        if not self.subgroup:
            return group
        inner = group.findGroup(self.subgroup)
        if inner is None:
            inner = group.insertGroup(place(group, self.order), self.subgroup)
            inner.setCustomProperty(ORDER, self.order)
            inner.setExpanded(self.subgroup == "Maps")
            inner.setItemVisibilityChecked(self.subgroup == "Maps")
        return inner


def moved(node, group, position):
    """The node at its new place: QGIS adds layers beside the current one, which may be in any group."""
    new = node.clone()
    group.insertChildNode(position, new)
    node.parent().removeChildNode(node)
    return new


def place(group, order):
    """Where in a group a node of this order belongs."""
    return sum(int(child.customProperty(ORDER, 0)) < order for child in group.children())


def map_title(name):
    """ "Energy total p95 [kJ]" for energy_total_p95_kJ."""
    ending = next((ending for ending in UNITS if name.endswith(ending)), "")
    words = name[: len(name) - len(ending)].replace("_", " ")
    return words[:1].upper() + words[1:] + (f" [{UNITS[ending]}]" if ending else "")


def tables_of(geopackage):
    """Names of the layers of a GeoPackage that have rows, read without a change to it."""
    if not geopackage.exists():
        return set()
    with closing(sqlite3.connect(f"{geopackage.as_uri()}?mode=ro&immutable=1", uri=True)) as database:
        names = {name for (name,) in database.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
        return {
            name for name in TABLES if name in names and database.execute(f'SELECT 1 FROM "{name}" LIMIT 1').fetchone()
        }


def map_order(file):
    return (FIRST_MAPS.index(file.stem) if file.stem in FIRST_MAPS else len(FIRST_MAPS), file.stem)


def entries(folder, name):
    """All layers of the results in a folder, from the top of the group to its bottom."""
    load, found = uuid.uuid4().hex, []

    def add(subgroup, source, title, kind, shown):
        found.append(Entry(load, f"Talus: {name}", subgroup, len(found), str(source), title, kind, shown))

    tables = tables_of(folder / "results.gpkg")
    for table, (title, shown) in TABLES.items():
        if table in tables:
            add("", f"{folder / 'results.gpkg'}|layername={table}", title, table, shown)
    maps = folder / "maps"
    for file in sorted(maps.glob("*.tif"), key=map_order):
        add("Maps", file, map_title(file.stem), "map", file.stem == SHOWN_MAP)
    for source in sorted((maps / "by_source").glob("*/")):
        for file in sorted(source.glob("*.tif"), key=map_order):
            add(f"Maps of {source.name}", file, map_title(file.stem), "map", False)
    return found


def load(folder, context, feedback):
    """Has the results in a folder loaded when the algorithm ends; returns their sources."""
    folder = Path(folder)
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        name = summary["name"]
    except FileNotFoundError:
        raise QgsProcessingException(f"{folder} has no results of Talus: there is no summary.json.") from None
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise QgsProcessingException(f"{folder / 'summary.json'} is no summary of a run of Talus: {error}") from None
    try:
        found = entries(folder, name)
    except sqlite3.Error as error:
        raise QgsProcessingException(f"{folder / 'results.gpkg'} is damaged: {error}. Run the project again.") from None
    if not found:
        raise QgsProcessingException(
            f"{folder} has no maps and no results.gpkg. The workbench and the report show a section "
            "(2D); in 3D, results.gpkg and maps can be switched off in [output]."
        )
    if summary.get("interrupted"):
        feedback.pushWarning("The run was interrupted: these are the results of the rocks until then.")
    if context.project() is not None:
        for entry in found:
            details = QgsProcessingContext.LayerDetails(entry.title, context.project(), "")
            details.forceName = True
            details.layerTypeHint = (
                QgsProcessingUtils.LayerHint.Raster if entry.kind == "map" else QgsProcessingUtils.LayerHint.Vector
            )
            details.setPostProcessor(kept(entry))
            context.addLayerToLoadOnCompletion(entry.source, details)
    return [entry.source for entry in found]
