from qgis.core import QgsProcessingOutputMultipleLayers, QgsProcessingParameterFile

from .. import results
from .base import Algorithm


class LoadResults(Algorithm):
    NAME = "loadresults"
    TITLE = "Load results"
    ABOUT = "Adds the maps, trajectories, end points and barriers of a run to the project, styled and in a group."

    def initAlgorithm(self, configuration=None):
        self.add(
            QgsProcessingParameterFile("RESULTS", "Folder of the results", QgsProcessingParameterFile.Folder),
            "The folder with summary.json and maps.",
        )
        self.addOutput(QgsProcessingOutputMultipleLayers("LAYERS", "Layers"))

    def canExecute(self):
        return True, ""  # without the program, too

    def processAlgorithm(self, values, context, feedback):
        return {"LAYERS": results.load(self.path(values, "RESULTS", context), context, feedback)}
