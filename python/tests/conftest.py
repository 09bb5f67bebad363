"""What several tests use. The paths come from CTest (test/CMakeLists.txt)."""

import os
from pathlib import Path
import subprocess

import pytest

SOURCE = Path(os.environ["TALUS_SOURCE"])
PROGRAM = os.environ["TALUS_PROGRAM"]

UNDER_ASAN = "libasan" in os.environ.get("LD_PRELOAD", "")

SLOPE = """
name = "Slope"
[terrain]
section = [[0, 50], [40, 10], [100, 0]]
[[material]]
name = "Rock"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.03 }
[[material]]
name = "Scree"
[ground]
segments = ["Rock", "Scree"]
[[seeder]]
name = "Crest"
type = "point"
position = [1, "surface"]
rocks = 200
mass_kg = { mean = 500, distribution = "uniform", rel_min = 200, rel_max = 200 }
horizontal_velocity_m_s = 2
[[barrier]]
name = "Fence"
line = 35
height_m = 2
capacity_kJ = 60
[output]
report = false
"""


@pytest.fixture
def slope():
    import talus

    return talus.Project.from_text(SLOPE, file="slope.toml")


@pytest.fixture
def program():
    def run(*arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True)

    return run
