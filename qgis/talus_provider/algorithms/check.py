import os

from .. import program
from .project import ProjectAlgorithm


class Check(ProjectAlgorithm):
    NAME = "check"
    TITLE = "Check"
    ABOUT = (
        "Writes the layers and settings as a project and reports everything that is wrong with it, the number of rocks "
        "and how long a run would take, without running it."
    )

    def processAlgorithm(self, values, context, feedback):
        project = self.write_project(values, context, feedback)
        if not feedback.isCanceled():
            program.run(["check", project], feedback)
        return {"PROJECT_FILE": project, "OUTPUT": os.path.dirname(project)}
