import os

from qgis.core import QgsProcessingOutputFolder, QgsProcessingParameterBoolean

from .base import run_and_load
from .project import ProjectAlgorithm


class Simulate(ProjectAlgorithm):
    NAME = "simulate"
    TITLE = "Simulate rockfall"
    ABOUT = (
        "Simulates rocks from release areas down a DEM and loads maps, trajectories, end points and barriers, styled"
        " and in a group. The layers are written beside a project file in a folder, which the program talus can run"
        " again with the same results. Cancel keeps what is done so far: load it with <i>Load results</i>, or continue"
        " with <i>Run a project file</i>."
    )

    def initAlgorithm(self, configuration=None):
        super().initAlgorithm(configuration)
        self.add(
            QgsProcessingParameterBoolean("LOAD", "Load the results into the project", True),
            "Adds the results to the map, in a group.",
        )
        self.addOutput(QgsProcessingOutputFolder("RESULTS", "Folder of the results"))

    def processAlgorithm(self, values, context, feedback):
        project = self.write_project(values, context, feedback)
        folder = os.path.splitext(project)[0]
        found = {"PROJECT_FILE": project, "RESULTS": folder, "OUTPUT": os.path.dirname(project)}
        if feedback.isCanceled():
            return found
        run_and_load(project, folder, [], self.parameterAsBoolean(values, "LOAD", context), context, feedback)
        return found
