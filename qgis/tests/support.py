"""QGIS without a window, with the provider, and layers to try it with."""

import atexit
import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
# A profile of its own: tests neither read nor change the user's settings.
PROFILE = tempfile.TemporaryDirectory()
atexit.register(PROFILE.cleanup)
os.environ["QGIS_CUSTOM_CONFIG_PATH"] = PROFILE.name

SOURCES = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("TALUS_PROGRAM", SOURCES / "build/talus")).resolve()
VALLEY, CLIFFS = (
    Path(shutil.copy(SOURCES / "examples/first-gis-run" / name, PROFILE.name))  # QGIS may write statistics beside them
    for name in ("valley.tif", "cliffs.geojson")
)
PLUGINS = SOURCES / "qgis"
sys.path[:0] = [str(PLUGINS), "/usr/share/qgis/python/plugins"]

from qgis.core import (  # noqa: E402
    QgsApplication,
    QgsFeature,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProject,
    QgsVectorLayer,
)

application = QgsApplication([], False)
application.initQgis()

import processing  # noqa: E402
from processing.core.Processing import Processing  # noqa: E402
from processing.core.ProcessingConfig import ProcessingConfig  # noqa: E402

Processing.initialize()

from talus_provider.provider import TalusProvider  # noqa: E402

provider = TalusProvider()
QgsApplication.processingRegistry().addProvider(provider)
ProcessingConfig.setSettingValue("TALUS_PROGRAM", str(PROGRAM))


def vector(geometry_type, crs, fields, features, name="layer"):
    """A layer in memory; `features` are pairs of WKT and attributes."""
    declared = "".join(f"&field={field}" for field in fields)
    layer = QgsVectorLayer(f"{geometry_type}?crs={crs}{declared}", name, "memory")
    layer.dataProvider().addFeatures([feature(layer, *each) for each in features])
    layer.updateExtents()
    return layer


def feature(layer, wkt, attributes):
    made = QgsFeature(layer.fields())
    made.setGeometry(QgsGeometry.fromWkt(wkt))
    made.setAttributes(attributes)
    return made


class Feedback(QgsProcessingFeedback):
    """Keeps what is said; can cancel at the first progress."""

    def __init__(self, cancel=False):
        super().__init__(False)
        self.said, self.steps = [], []
        self.progressChanged.connect(self.steps.append)
        if cancel:
            self.progressChanged.connect(lambda progress: progress > 0 and self.cancel())

    def pushInfo(self, text):
        self.said.append(text)

    pushWarning = pushCommandInfo = pushInfo


class Case(unittest.TestCase):
    """A folder for the project, and the algorithms."""

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = Path(kept.name)
        self.feedback = Feedback()

    def values(self, **more):
        """A run of the valley that takes a blink."""
        return {
            "DEM": str(VALLEY),
            "RELEASE": str(CLIFFS),
            "SEEDER_MIN_SLOPE_DEG": 55,
            "SEEDER_ROCKS": 200,
            "SEEDER_HEIGHT_ABOVE_M": 2,
            "SEEDER_DIAMETER_M": "0.8",
            "NAME": "valley",
            "OUTPUT": str(self.folder / "project"),
            "LOAD": False,
            **more,
        }

    def run_algorithm(self, name, **values):
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        return processing.run(f"talus:{name}", values, feedback=self.feedback, context=context)

    def simulate(self, **more):
        return self.run_algorithm("simulate", **self.values(**more))

    def check(self, **more):
        values = self.values(**more)
        del values["LOAD"]
        return self.run_algorithm("check", **values)

    def refusal(self, call, **more):
        """The text with which an algorithm refuses."""
        with self.assertRaises(QgsProcessingException) as refused:
            call(**more)
        return str(refused.exception)

    def project_text(self):
        return (self.folder / "project/valley.toml").read_text(encoding="utf-8")
