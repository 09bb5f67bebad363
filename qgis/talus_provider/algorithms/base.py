import html
import os

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterDefinition
from qgis.PyQt.QtGui import QIcon

from .. import program, results


def run_and_load(project, folder, options, wants_layers, context, feedback):
    """Runs a project file into a folder, and has its results loaded if they are wanted and complete."""
    stopped = program.run(["run", project, "-o", folder, *options], feedback) == program.STOPPED
    if not stopped and wants_layers:
        results.load(folder, context, feedback)
    elif stopped and os.path.exists(os.path.join(folder, "summary.json")):
        feedback.pushInfo("Load the results so far with Load results, or continue with Run a project file.")
    elif stopped:
        feedback.pushInfo("Continue with Run a project file.")


class Algorithm(QgsProcessingAlgorithm):
    """What all algorithms of the provider have in common. A subclass gives NAME, TITLE and ABOUT (HTML)."""

    def createInstance(self):
        return type(self)()

    def name(self):
        return self.NAME

    def displayName(self):
        return self.TITLE

    def shortDescription(self):
        return self.ABOUT

    def shortHelpString(self):
        shown = [
            each
            for each in self.parameterDefinitions()
            if each.help() and not each.flags() & QgsProcessingParameterDefinition.FlagAdvanced
        ]
        rows = "".join(f"<p><b>{html.escape(each.description())}</b><br>{each.help()}</p>" for each in shown)
        return f"<p>{self.ABOUT}</p>{rows}"

    def icon(self):
        from ..provider import ICON

        return QIcon(ICON)

    def canExecute(self):
        try:
            program.schema()
        except (OSError, ValueError) as error:
            return False, str(error)
        return True, ""

    def checkParameterValues(self, values, context):
        can, why = self.canExecute()  # processing.run does not ask
        return super().checkParameterValues(values, context) if can else (False, why)

    def schema(self):
        """The declaration of the settings, or None while there is no program; canExecute then says so."""
        try:
            return program.schema()
        except (OSError, ValueError):
            return None

    def named(self, name):
        """A parameter as its user meets it, by its name in the dialog and on the command line."""
        return f'"{self.parameterDefinition(name).description()}" ({name})'

    def path(self, values, name, context):
        """The file or folder that a parameter gives, as an absolute path: on the command line it may be relative."""
        is_output = self.parameterDefinition(name).isDestination()
        given = (self.parameterAsFileOutput if is_output else self.parameterAsFile)(values, name, context)
        return os.path.abspath(given)

    def add(self, parameter, help_text):
        parameter.setHelp(help_text)
        self.addParameter(parameter)
