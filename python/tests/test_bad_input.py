"""Bad input is an error with its place, and never a crash."""

import shutil

import numpy as np
import pytest

import talus

from conftest import SLOPE, SOURCE, UNDER_ASAN


def problems_of(call):
    with pytest.raises(talus.BadInput) as caught:
        call()
    assert str(caught.value) == "\n".join(problem.text for problem in caught.value.problems)
    return caught.value.problems


def test_all_problems_have_their_places(tmp_path):
    file = tmp_path / "slope.toml"
    file.write_text(SLOPE.replace("mean = 0.4", "mean = 4").replace("rocks = 200", "rocks = -1").replace("height_m", "hight_m"))
    found = problems_of(lambda: talus.Project.read(file))
    assert [(problem.path, problem.line) for problem in found] == [
        ("material.0.normal_restitution.mean", 7), ("seeder.0.rocks", 16), ("barrier.0.hight_m", 22)]
    assert found[0].file == str(file) and found[0].severity == "error" and found[0].why and found[0].hint


@pytest.mark.parametrize("value", [float("nan"), "high", [1, 2], {"mean": "x"}, True, -1, 1e400])
def test_wrong_values_of_a_setting(slope, value):
    model = talus.prepare(slope)
    found = problems_of(lambda: model.run(material={"Scree": {"normal_restitution": value}}))
    assert "normal_restitution" in str(found[0])


@pytest.mark.parametrize("arguments", [
    {"rocks": 0}, {"rocks": -1}, {"rocks": 1.5}, {"rocks": "many"}, {"rocks": float("nan")}, {"rocks": 2**70}, {"seed": -1},
    {"threads": -1}, {"threads": 5000}, {"threads": 1.0}, {"progress": 3}, {"material": {"Granite": {"roughness_deg": 1}}},
    {"material": {"Scree": 3}}, {"nonsense": {"a": 1}}, {"": 1}, {"material": [1]}, {"material": {"Scree": {"a=b": 1}}}])
def test_wrong_arguments_of_a_run(slope, arguments):
    model = talus.prepare(slope)
    problems_of(lambda: model.run(**arguments))


def said_by(call):
    return "\n".join(problem.text for problem in problems_of(call))


def test_keyword_arguments_are_named_as_they_were_written(slope):
    model = talus.prepare(slope)
    assert said_by(lambda: model.run(material={"Scree": {"normal_restitution": 9}})).startswith(
        'material={"Scree": {"normal_restitution": 9}}: material "Scree": normal_restitution is 9 (')
    assert said_by(lambda: model.run(material={"Scree": {"normal_restitution": talus.Normal(9, 0.1)}})).startswith(
        'material={"Scree": {"normal_restitution": {"mean": 9, "distribution": "normal", "std_dev": 0.1}}}: ')
    assert said_by(lambda: slope.changed(analysis={"gravity": 9})) == (
        'analysis={"gravity": 9}: analysis: unknown key "gravity". Did you mean "gravity_m_s2"?')
    assert said_by(lambda: model.run(output={"trajectories": "some"})).startswith(
        'output={"trajectories": "some"}: output: trajectories is "some" (')
    assert said_by(lambda: model.run(materials={"Scree": {"roughness_deg": 1}})) == (
        'materials={"Scree": {"roughness_deg": 1}}: unknown table materials. Did you mean material=[...]?')
    assert said_by(lambda: talus.run("none.toml")).endswith("talus.Project.starter() writes a project to start from")
    assert said_by(lambda: model.run(rocks=0)) == "rocks=0: expected a whole number, at least 1"
    assert said_by(lambda: talus.run(slope, rocks=10**13)).startswith("rocks=10000000000000: this is not a number of rocks")
    assert said_by(lambda: talus.follow(slope, 200)).startswith("rock=200: there is no such rock (")
    assert said_by(lambda: talus.run(slope, rocks=1).save("/proc/none")).endswith("Choose another folder")


def test_a_project_of_tables_has_no_file():
    said = said_by(lambda: talus.Project(
        terrain=talus.Terrain(section=[[0, 1], [5, 0]]), seeder=[talus.Seeder(position=[0.5, "surface"], mass_kg=-1)],
        material=[talus.Material(name="Rock", normal_restitution=talus.Normal(1.3, 0.1))], nonsense=1))
    assert "project.toml" not in said and "\nmaterial \"Rock\": normal_restitution mean is 1.3 (" in said
    assert said_by(lambda: talus.Project()).splitlines()[:2] == [
        "terrain is missing (a project needs it)", "material=[...] is missing (a project needs at least one)"]
    lacking = talus.Project(terrain=talus.Terrain(raster="none.tif"), material=[talus.Material(name="Rock")],
                            seeder=[talus.Seeder(position=[1, 1, "surface"], rocks=1, mass_kg=1)])
    assert said_by(lambda: talus.run(lacking)).startswith("terrain: raster none.tif: cannot be read (")


def test_names_that_are_nearly_right(slope):
    result = talus.run(slope)
    assert said_by(lambda: talus.columns("endpoints")).endswith('Did you mean "end_points"?')
    assert said_by(lambda: talus.plots.histogram(result, "max_ke_kJ")).endswith('Did you mean "max_ke_J"?')
    assert "it has words" in said_by(lambda: talus.plots.histogram(result, "seeder"))
    assert said_by(lambda: talus.plots.barrier_curves(result, "Fense")).endswith('Did you mean "Fence"?')
    assert said_by(lambda: result.line(barrier="Fense")).startswith("barrier: ")
    assert "plots.section" in said_by(lambda: talus.plots.plan(result))


def test_wrong_questions_to_a_run(slope):
    result = talus.run(slope)
    assert said_by(lambda: result.line()) == "nothing is asked for (expected one of line, polygon and barrier)"
    assert said_by(lambda: result.line(20, barrier="Fence")).startswith("line, barrier are given (")
    assert said_by(lambda: result.line(20, height=3)) == "energy is missing (a kit has a height and an energy)"
    assert said_by(lambda: result.line(20, height=-3, energy=9)).startswith("height=-3: expected")
    assert said_by(lambda: result.line(2000)).startswith("line: ")
    assert said_by(lambda: result.line([1, 2, 3])).startswith("line has the shape (3,) (expected (n, 2)")
    assert said_by(lambda: result.line(20, design={"standart": "none"})).startswith('design={"standart": "none"}: ')
    problems_of(lambda: result.polygon([[0, 0], [10, 0], [10, 10]]))
    none = talus.run(slope, output={"trajectories": "none", "trajectories_MB": "none"})
    assert said_by(lambda: none.line(20)).startswith("the run has no stored trajectories (")
    assert "steps" in said_by(lambda: talus.what_if(slope, 20, steps={"normal_restituion": 0.1}))
    assert said_by(lambda: talus.what_if(slope, 20, steps=["mass"])).startswith("steps=['mass']: expected")
    assert said_by(lambda: talus.what_if(slope, 20, steps={"mass": "a lot"})).startswith('steps["mass"]=')
    assert said_by(lambda: talus.what_if(slope, 20, within=-1)).startswith("within=-1: expected")
    assert "Scree" in said_by(lambda: talus.what_if(slope, 20, material="Scre"))


@pytest.mark.skipif(UNDER_ASAN, reason="the sanitizer ends the process")
def test_more_rocks_than_memory_holds(slope):
    with pytest.raises(MemoryError, match="end points of 1000000000000 rocks .keep fewer"):
        talus.prepare(slope).run(rocks=10**12)


def test_a_setting_of_no_known_kind(slope):
    for value in (object(), None, np.longdouble(9), talus.Normal):
        with pytest.raises(TypeError, match="^analysis.gravity_m_s2 cannot be"):
            slope.changed(analysis={"gravity_m_s2": value})
    with pytest.raises(TypeError, match="^barrier cannot be None"):
        talus.Project(barrier=None)


def test_what_is_no_project(slope):
    model = talus.prepare(slope)
    for wrong in (lambda: talus.run(model), lambda: talus.run({}), lambda: talus.Model("slope.toml"),
                  lambda: talus.Project.read(None)):
        with pytest.raises(TypeError):
            wrong()
    for text in (3, b"name", "\udc80"):
        problems_of(lambda: talus.Project.from_text(text))
    for path in ("", "a\0b"):
        problems_of(lambda: talus.Project.read(path))
        problems_of(lambda: slope.write(path))
        problems_of(lambda: talus.run(slope, rocks=1).save(path))
    problems_of(lambda: slope.changed(name="\udcff"))
    problems_of(lambda: slope.changed(material={"Nobody": {}}))
    problems_of(lambda: model.follow(None))
    problems_of(lambda: talus.columns(None))


def test_a_file_that_is_not_written_leaves_nothing(slope, tmp_path):
    (tmp_path / "slope.toml").mkdir()
    problems_of(lambda: slope.write(tmp_path / "slope.toml"))
    assert [each.name for each in tmp_path.iterdir()] == ["slope.toml"]


def test_a_project_written_elsewhere_warns_of_its_files(tmp_path):
    project = talus.Project.read(SOURCE / "examples/maungawhau/maungawhau.toml")
    with pytest.warns(UserWarning, match="there is no maungawhau.asc beside it"):
        project.write(tmp_path / "away.toml")


def test_wrong_typed_tables():
    found = problems_of(lambda: talus.Project(
        terrain=talus.Terrain(section=np.array([[0, 1], [np.nan, 0]])),
        material=[talus.Material(name="Rock", normal_restitution=talus.Normal(1.3, 0.1))],
        seeder=[talus.Seeder(position=[0.5, "surface"], rocks=1, mass_kg=-1)], nonsense=1))
    assert {problem.path for problem in found} >= {"material.0.normal_restitution.mean", "seeder.0.mass_kg", "nonsense"}
    with pytest.raises(TypeError):
        talus.Material(nam="Rock")


def test_files_that_are_not_there(tmp_path, slope):
    problems_of(lambda: talus.run(tmp_path / "none.toml"))
    problems_of(lambda: talus.Project.read(tmp_path))
    problems_of(lambda: talus.open_results(tmp_path))
    problems_of(lambda: talus.run(slope).save("/proc/none"))
    problems_of(lambda: slope.write(tmp_path / "none" / "slope.toml"))


def test_a_folder_that_was_damaged(tmp_path, slope):
    folder = talus.run(slope, output={"report": False}).save(tmp_path / "out")
    assert talus.open_results(folder).rocks == 200
    text = (folder / "endpoints.csv").read_text()
    (folder / "endpoints.csv").write_text(text[:-30])
    problems_of(lambda: talus.open_results(folder).end_points)
    (folder / "paths.csv").unlink()
    problems_of(lambda: talus.open_results(folder).events)
    for damage in ("", "[]", '{"rocks": {"planned": 1, "done": 1}}', "{", "[" * 100_000, '{"rocks": 3}', "\0"):
        (folder / "summary.json").write_text(damage)
        problems_of(lambda: talus.open_results(folder))
    (folder / "summary.json").write_bytes(b"\xff\xfe")
    problems_of(lambda: talus.open_results(folder))


def test_files_that_vanish_while_a_model_is_used(tmp_path):
    shutil.copy(SOURCE / "examples/maungawhau/maungawhau.asc", tmp_path)
    shutil.copy(SOURCE / "examples/maungawhau/maungawhau.toml", tmp_path)
    model = talus.prepare(tmp_path / "maungawhau.toml")
    expected = model.run(rocks=20)
    (tmp_path / "maungawhau.asc").unlink()
    (tmp_path / "maungawhau.toml").unlink()
    assert model.run(rocks=20).end_points.tobytes() == expected.end_points.tobytes()
    assert (expected.save(tmp_path / "out") / "summary.json").exists()


def test_hostile_projects():
    """Those of the fuzzer: each is read, or refused."""
    for file in sorted((SOURCE / "fuzz/corpus/project").iterdir()):
        try:
            talus.Project.from_text(file.read_bytes().decode("utf-8", "surrogateescape"))
        except talus.BadInput:
            pass


def test_wrong_shapes():
    law = {"mass": 1, "radius": 1, "normal_restitution": 0.5, "tangential_restitution": 0.5}
    for velocity in ([5, 0, 8], 1, [1, 2], np.zeros((2, 2)), "fast", [[0, 0, np.nan]], None):
        problems_of(lambda: talus.impact.crsp(velocity, **law))
    problems_of(lambda: talus.impact.crsp(np.zeros((3, 3)), np.zeros((2, 3)), **law))
    problems_of(lambda: talus.impact.crsp([0, 0, -1], normal=[0, 0, 2], **law))
    problems_of(lambda: talus.impact.crsp([0, 0, -1], **{**law, "mass": 0}))
    for name in ("mass", "radius"):
        problems_of(lambda: talus.impact.crsp([0, 0, -1], **{**law, name: np.inf}))
    for time in ([0, -1], np.inf, None, "1", True):
        problems_of(lambda: talus.flight.at([0, 0, 0], [0, 0, 0], time))
    problems_of(lambda: talus.flight.at([0, 0, 0], [0, 0, 0], 1, gravity=[1, 2]))
    surface = talus.prepare(talus.Project.starter()).surface
    problems_of(lambda: surface.elevation([1, 2], [1, 2, 3]))
    problems_of(lambda: surface.first_contact([0, 0, 0], [0, 0, 0], radius=-1))
    problems_of(lambda: surface.section([[0, 0], [10, 0]]))
    for line in ([], [[0, 0]], [0, 1], [[0, 0, 0], [1, 1, 1]], [[0, np.nan], [1, 1]], "line"):
        problems_of(lambda: surface.section(line))
    assert np.isnan(surface.elevation([np.nan, np.inf, 1e300])).all()
    assert np.isnan(surface.first_contact([np.nan, 0, 0], [0, 0, 0]).time)


def test_names_that_do_not_exist(slope):
    result = talus.run(slope, rocks=5)
    with pytest.raises(KeyError, match="there is no map"):
        result.maps["height"]
    with pytest.raises(KeyError):
        result.maps[3]
    for call in (lambda: result.frame("rocks"), lambda: talus.columns("rocks"),
                 lambda: talus.plots.histogram(result, "seeder"), lambda: talus.plots.barrier_curves(result, "Wall")):
        problems_of(call)
