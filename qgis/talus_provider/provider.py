import os

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from processing.core.ProcessingConfig import ProcessingConfig, Setting

from . import program
from .algorithms.check import Check
from .algorithms.design import DesignAlongLine
from .algorithms.load_results import LoadResults
from .algorithms.run_project import RunProject
from .algorithms.simulate import Simulate

ICON = os.path.join(os.path.dirname(__file__), "icon.svg")


def refuse_wrong_program(path):
    if path and not program.is_program(path):
        raise ValueError(f"{path} is not a program")


class TalusProvider(QgsProcessingProvider):
    def load(self):
        ProcessingConfig.settingIcons[self.name()] = self.icon()
        ProcessingConfig.addSetting(
            Setting(
                self.name(),
                program.SETTING,
                "Program talus (empty: found on the PATH and in the usual places)",
                "",
                valuetype=Setting.FILE,
                validator=refuse_wrong_program,
            )
        )
        ProcessingConfig.readSettings()
        self.refreshAlgorithms()
        return True

    def unload(self):
        ProcessingConfig.removeSetting(program.SETTING)

    def loadAlgorithms(self):
        for algorithm in (Simulate(), Check(), RunProject(), DesignAlongLine(), LoadResults()):
            self.addAlgorithm(algorithm)

    def id(self):
        return "talus"

    def name(self):
        return "Talus"

    def longName(self):
        return "Talus (rockfall)"

    def icon(self):
        return QIcon(ICON)

    def svgIconPath(self):
        return ICON
