"""Projects made in Python."""

import json
import os
from pathlib import Path

import numpy as np
import pytest

import settings_module
import talus
from talus.toml_text import inline_text, plain, project_text

from conftest import SLOPE, SOURCE


def test_a_project_of_typed_tables_is_that_of_its_text(slope, tmp_path):
    ours = talus.Project(
        name="Slope",
        terrain=talus.Terrain(section=np.array([[0, 50], [40, 10], [100, 0]])),
        material=[talus.Material(name="Rock", normal_restitution=talus.Normal(0.4, 0.03)), {"name": "Scree"}],
        ground=talus.Ground(segments=["Rock", "Scree"]),
        seeder=[talus.Seeder(name="Crest", type="point", position=[1, "surface"], rocks=200,
                             mass_kg=talus.Uniform(500, rel_min=200, rel_max=200), horizontal_velocity_m_s=2)],
        barrier=[talus.Barrier(name="Fence", line=35, height_m=2, capacity_kJ=np.float64(60))],
        output=talus.Output(report=False))
    assert ours.settings == slope.settings
    file = ours.write(tmp_path / "slope.toml")
    assert talus.Project.read(file).settings == slope.settings
    assert talus.run(ours).end_points.tobytes() == talus.run(slope).end_points.tobytes()


def test_shapes_are_made_from_what_is_known_of_a_block(tmp_path):
    (tmp_path / "block.xyz").write_text("0 0 0\n1 0 0\n0 2 0\n0 0 3\n")
    shapes = [
        talus.Shape.ellipsoid(0.6, 1.2, 0.9, name="rounded"), talus.Shape.box(1, 2, 3, name="box"),
        talus.Shape.ratios(talus.Normal(0.8, 0.1), 0.5, name="slabs", style="angular"),
        talus.Shape.prism(6, length_ratio=2, name="column"), talus.Shape.scan("block.xyz", name="scan"),
        talus.Shape.group({"box": 1, "cube": 3}, name="mixed")]
    project = talus.Project(
        folder=tmp_path, analysis=talus.Analysis(model="rigid_body"),
        terrain=talus.Terrain(section=[[0, 50], [40, 10], [100, 0]], width_m=20), material=[talus.Material(name="Rock")],
        shape=shapes, output=talus.Output(report=False),
        seeder=[talus.Seeder(name=each.name, position=[1, 10], height_above_m=2, rocks=3, mass_kg=500, shape=each.name)
                for each in shapes])
    assert [each["name"] for each in project.settings["shape"]] == [each.name for each in shapes]
    assert project.settings["shape"][4]["scan"] == "block.xyz"
    ends = talus.run(project).end_points
    assert len(ends) == 18 and (ends["runout_xy_m"] > 10).all()
    again = talus.Project.read(project.write(tmp_path / "shapes.toml"))
    assert again.settings["shape"] == project.settings["shape"]


def test_a_project_that_was_read_is_written_as_it_is(slope, tmp_path):
    assert slope.write(tmp_path / "slope.toml").read_text() == SLOPE
    changed = slope.changed(rocks=77, material={"Rock": {"friction_angle_deg": 35}})
    again = talus.Project.read(changed.write(tmp_path / "changed.toml"))
    assert again.settings == changed.settings and again.settings["material"][0]["friction_angle_deg"]["mean"] == 35


def test_a_barrier_without_limit_stays_one(slope, tmp_path):
    text = SLOPE.replace("capacity_kJ = 60\n", "")
    changed = talus.Project.from_text(text).changed(seed=3)
    assert changed.settings["barrier"][0]["capacity_kJ"] == float("inf")
    assert talus.Project.read(changed.write(tmp_path / "open.toml")).settings == changed.settings
    result = talus.run(changed, rocks=5)
    assert result.project.settings == result.project.changed().settings and result.project.name == "Slope"


def test_the_text_is_that_of_the_workbench():
    """python/tests/written.toml is what the workbench writes for written.json (web/src/toml/written.test.ts)."""
    folder = Path(__file__).parent
    settings = json.loads((folder / "written.json").read_text())
    assert project_text(settings) == (folder / "written.toml").read_text()


@pytest.mark.parametrize("number, text", [
    (0.1, "0.1"), (3.0, "3"), (-0.0, "0"), (1e-7, "1e-7"), (1.5e-7, "1.5e-7"), (0.000015, "0.000015"), (1e21, "1e+21"),
    (1e20, "100000000000000000000"), (1e16, "10000000000000000"), (1e300, "1e+300"), (float("inf"), "inf"),
    (123456.789, "123456.789"), (np.float32(0.5), "0.5"), (True, "true"), (5, "5"), (-2.5e-6, "-0.0000025")])
def test_numbers_are_written_as_in_javascript(number, text):
    assert inline_text(plain(number)) == text


def test_the_module_of_settings_is_not_stale():
    file = SOURCE / "python/talus/settings.py"
    text = settings_module.settings_module(talus.schema())
    if os.environ.get("TALUS_RENEW_REFERENCE"):
        file.write_text(text)
    assert file.read_text() == text, "renew it with TALUS_RENEW_REFERENCE=1"


def test_help_has_units_ranges_and_defaults():
    assert "Unit: m/s2. Range: at least 1e-06, at most 1000. Default: 9.80665." in talus.Analysis.__doc__
    assert talus.schema()["properties"]["analysis"]["properties"]["gravity_m_s2"]["default"] == 9.80665
