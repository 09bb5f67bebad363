"""Talus simulates rockfall: where rocks go, how fast, how high and with what energy, and which barrier stops them.

In ten lines::

    import talus

    project = talus.Project.read("slope.toml")
    result = talus.run(project, rocks=1000)
    result.end_points["runout_xy_m"].mean()
    result.save("out")
"""

from . import distributions as _distributions, flight, impact, plots, settings as _settings
from ._talus import __version__
from .answers import DitchAnswer, LineAnswer, PolygonAnswer
from .comparison import Comparison, Difference, compare
from .distributions import *
from .ensembles import Ensembles
from .estimates import Estimate
from .kits import Kit, KitAnswer, Stretch
from .maps import Map, MapClass
from .overrides import schema
from .problems import BadInput, Interrupted, Problem
from .project import Project
from .results import Column, Results, columns, open_results
from .runs import Model, follow, prepare, run
from .settings import *
from .rock_shapes import Shape
from .studies import Calibration, Sensitivity, calibrate, sensitivity
from .surface import Surface
from .trajectory import Trajectory
from .variations import Figures, Range, Variation, WhatIf, what_if

__all__ = [
    "__version__", "flight", "impact", "plots", "BadInput", "Calibration", "Column", "Comparison", "Difference",
    "DitchAnswer", "Ensembles", "Estimate", "Figures", "Interrupted", "Kit", "KitAnswer", "LineAnswer", "Map",
    "MapClass", "Model", "PolygonAnswer", "Problem", "Project", "Range", "Results", "Sensitivity", "Stretch", "Surface",
    "Trajectory", "Variation", "WhatIf", "calibrate", "columns", "compare", "follow", "open_results", "prepare", "run",
    "schema", "sensitivity", "what_if",
]
__all__ += _distributions.__all__
__all__ += _settings.__all__
