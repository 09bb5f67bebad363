import os

from qgis.core import (
    QgsProcessingOutputFolder,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFile,
)

from .base import Algorithm, run_and_load


class RunProject(Algorithm):
    NAME = "runproject"
    TITLE = "Run a project file"
    ABOUT = (
        "Runs a project file, such as one that <i>Simulate rockfall</i> or the workbench has written, and loads the "
        "results. A run that was cancelled is continued."
    )

    def initAlgorithm(self, configuration=None):
        self.add(QgsProcessingParameterFile("PROJECT_FILE", "Project file", extension="toml"), "A project of Talus.")
        self.add(
            QgsProcessingParameterBoolean("RESUME", "Continue a run that was cancelled", True),
            "Continues from the rocks that are in the folder of the results, if there are any of this project.",
        )
        self.add(
            QgsProcessingParameterBoolean("LOAD", "Load the results into the project", True),
            "Adds the results to the map, in a group.",
        )
        self.addOutput(QgsProcessingOutputFolder("RESULTS", "Folder of the results"))

    def processAlgorithm(self, values, context, feedback):
        project = self.path(values, "PROJECT_FILE", context)
        folder = os.path.splitext(project)[0]
        options = ["--resume"] if self.parameterAsBoolean(values, "RESUME", context) else []
        run_and_load(project, folder, options, self.parameterAsBoolean(values, "LOAD", context), context, feedback)
        return {"RESULTS": folder}
