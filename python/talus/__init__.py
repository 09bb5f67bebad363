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
from .distributions import *
from .maps import Map
from .overrides import schema
from .problems import BadInput, Interrupted, Problem
from .project import Project
from .results import Column, Results, columns, open_results
from .runs import Model, follow, prepare, run
from .settings import *
from .rock_shapes import Shape
from .surface import Surface
from .trajectory import Trajectory

__all__ = [
    "__version__", "flight", "impact", "plots", "Map", "schema", "BadInput", "Interrupted", "Problem", "Project", "Column",
    "Results", "columns", "open_results", "Model", "follow", "prepare", "run", "Surface", "Trajectory",
]
__all__ += _distributions.__all__
__all__ += _settings.__all__
