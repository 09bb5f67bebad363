"""Renews the pictures of qgis.md: /usr/bin/python3 docs/qgis_pictures.py [PROGRAM], after a build and `make test-qgis`,
which installs QGIS. QGIS runs on a display of its own (Xvfb), with an empty profile and the plugin of this tree, and
executes this file again. PROGRAM is build/talus if it is not given."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

SCREEN = "1280x800x24"


def start(program):
    sources = Path(__file__).resolve().parent.parent
    (sources / "out").mkdir(exist_ok=True)  # QGIS marks layers in the system's temporary folder
    with tempfile.TemporaryDirectory(dir=sources / "out") as folder:
        profile = Path(folder) / "profiles/profiles/default/QGIS"
        profile.mkdir(parents=True)
        (profile / "QGIS3.ini").write_text(
            "[PythonPlugins]\ntalus_provider=true\nprocessing=true\n\n[qgis]\ncheckVersion=false\nshowTips=false\n"
            "newsFeed\\\\disabled=true\n\n[locale]\noverrideFlag=true\nuserLocale=en_US\n\n"
            f"[Processing]\nConfiguration\\TALUS_PROGRAM={program}\n"
        )
        for file in ("valley.tif", "cliffs.geojson"):
            shutil.copy(sources / "examples/first-gis-run" / file, folder)
        running = subprocess.Popen(
            [
                "xvfb-run",
                "-a",
                "-s",
                f"-screen 0 {SCREEN}",
                "qgis",
                "--nologo",
                "--profiles-path",
                str(Path(folder) / "profiles"),
                "--code",
                str(Path(__file__).resolve()),
            ],
            env={
                **os.environ,
                "QGIS_PLUGINPATH": str(sources / "qgis"),
                "TALUS_PICTURES": folder,
                "QT_QPA_PLATFORM": "xcb",
                "TALUS_DOCS": str(sources / "docs"),
            },
            start_new_session=True,
        )
        try:
            sys.exit(running.wait(timeout=120))
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGTERM)
            sys.exit("QGIS did not end")


def take():
    """In QGIS: from an empty project to a map, with a picture of each stage."""
    import processing
    from qgis.core import (
        QgsApplication,
        QgsBilinearRasterResampler,
        QgsFeature,
        QgsGeometry,
        QgsHillshadeRenderer,
        QgsProcessingContext,
        QgsProject,
        QgsRasterLayer,
        QgsVectorLayer,
    )
    from qgis.PyQt.QtCore import QEventLoop, QTimer
    from qgis.PyQt.QtGui import QColor
    from qgis.PyQt.QtWidgets import QDockWidget, QTreeView
    from qgis.utils import iface

    folder, docs = Path(os.environ["TALUS_PICTURES"]), Path(os.environ["TALUS_DOCS"])
    project, window = QgsProject.instance(), iface.mainWindow()

    def wait(seconds):
        loop = QEventLoop()
        QTimer.singleShot(int(1000 * seconds), loop.quit)
        loop.exec_()

    def drawn():
        canvas = iface.mapCanvas()
        canvas.refreshAllLayers()
        canvas.waitWhileRendering()
        wait(2)

    def show(layer, is_shown):
        project.layerTreeRoot().findLayer(layer.id()).setItemVisibilityChecked(is_shown)

    def picture(name):
        iface.messageBar().clearWidgets()
        wait(1)
        QgsApplication.primaryScreen().grabWindow(0).save(str(docs / f"qgis-{name}.png"))

    def layers():
        terrain = QgsRasterLayer(str(folder / "valley.tif"), "valley")
        terrain.setRenderer(QgsHillshadeRenderer(terrain.dataProvider(), 1, 225, 45))
        terrain.resampleFilter().setZoomedInResampler(QgsBilinearRasterResampler())
        cliffs = QgsVectorLayer(str(folder / "cliffs.geojson"), "cliffs", "ogr")
        cliffs.renderer().symbol().setColor(QColor("#1f78b4"))
        cliffs.setOpacity(0.5)
        project.addMapLayers([cliffs, terrain])
        wait(1)
        project.setCrs(terrain.crs())
        iface.mapCanvas().setExtent(terrain.extent())
        return terrain, cliffs

    def dialog(terrain, cliffs):
        made = processing.createAlgorithmDialog(
            "talus:simulate",
            {
                "DEM": terrain.id(),
                "RELEASE": cliffs.id(),
                "SEEDER_MIN_SLOPE_DEG": 55,
                "SEEDER_ROCKS_PER_CELL": 5,
                "SEEDER_DIAMETER_M": "0.8",
                "SEEDER_HEIGHT_ABOVE_M": 2,
                "MATERIAL_LIKE": "talus_cover",
                "OUTPUT": str(folder / "project"),
            },
        )
        made.resize(900, 660)
        made.move(190, 70)
        made.show()
        return made

    def run(name, **values):
        context = QgsProcessingContext()
        context.setProject(project)
        return processing.runAndLoadResults(name, values, None, context)

    code = 1
    try:
        window.showNormal()
        window.setGeometry(0, 0, 1280, 800)
        for dock in window.findChildren(QDockWidget):
            dock.setVisible(dock.objectName() in ("Layers", "ProcessingToolbox"))
        toolbox = window.findChild(QDockWidget, "ProcessingToolbox").findChild(QTreeView)
        for row in range(toolbox.model().rowCount()):
            group = toolbox.model().index(row, 0)
            if group.data() == "Talus":
                toolbox.expandRecursively(group)
                toolbox.scrollTo(group, QTreeView.PositionAtTop)
        wait(2)
        loaded = layers()
        drawn()
        shown = dialog(*loaded)
        wait(2)
        picture("dialog")
        shown.runAlgorithm()
        while not shown.wasExecuted():
            wait(0.5)
        shown.close()
        drawn()
        picture("map")
        lines = QgsVectorLayer("LineString?crs=EPSG:25832&field=name:string", "fence", "memory")
        line = QgsFeature(lines.fields())
        line.setGeometry(
            QgsGeometry.fromWkt("LINESTRING (652150 5234180, 652360 5234150, 652560 5234150, 652700 5234165)")
        )
        line.setAttributes(["Fence"])
        lines.dataProvider().addFeature(line)
        run(
            "talus:designalongline",
            RESULTS=str(folder / "project/rockfall"),
            LINES=lines,
            DESIGN_SECTION_M=25,
            OUTPUT="TEMPORARY_OUTPUT",
        )
        cliffs, trajectories = loaded[1], project.mapLayersByName("Trajectories")[0]
        show(cliffs, False)
        show(trajectories, True)
        project.layerTreeRoot().findGroup("Maps").setItemVisibilityChecked(False)
        project.layerTreeRoot().findGroup("Maps").setExpanded(False)
        for layer in (trajectories, project.mapLayersByName("Stretches")[0]):
            project.layerTreeRoot().findLayer(layer.id()).setExpanded(True)
        drawn()
        picture("design")
        code = 0
    except Exception:
        traceback.print_exc()
    sys.stderr.flush()
    os._exit(code)  # without questions about a project that is not saved


if "TALUS_PICTURES" in os.environ:
    take()
else:
    start(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent / "build/talus").resolve())
