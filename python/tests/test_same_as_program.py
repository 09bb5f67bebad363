"""The package and the program give the same bits."""

import filecmp
import json

import pytest

import talus

from conftest import SOURCE

EXAMPLES = [
    "tutorial-1/tutorial-1-2d", "tutorial-1/tutorial-1-3d", "sliding/sliding", "barrier/barrier", "bowl/bowl",
    "maungawhau/maungawhau", "maungawhau/crater", "maungawhau/barrier-design", "first-gis-run/first-gis-run",
    "calibration/slope",
]
CASES = sorted(file.relative_to(SOURCE / "verification").as_posix() for file in (SOURCE / "verification").glob("*/*.toml")
               if file.name != "case.toml")
ROCKS = 40


def summary_without_timings(folder):
    summary = json.loads((folder / "summary.json").read_text())
    del summary["timings"]
    return summary


def names(folder):
    return sorted(str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file())


@pytest.mark.parametrize("example", EXAMPLES)
def test_every_file_of_an_example_has_the_same_bytes(example, program, tmp_path):
    file = SOURCE / "examples" / f"{example}.toml"
    theirs, ours = tmp_path / "program", tmp_path / "package"
    if "rocks_per_cell" in file.read_text():
        options, settings = ["--set", "seeder.0.rocks_per_cell=1"], {"seeder": {"0": {"rocks_per_cell": 1}}}
    else:
        options, settings = ["--rocks", ROCKS], {"rocks": ROCKS}
    program("run", file, *options, "-o", theirs, "-q")
    result = talus.run(file, **settings)
    result.save(ours)
    assert names(ours) == names(theirs)
    different = [name for name in names(ours) if not filecmp.cmp(ours / name, theirs / name, shallow=False)]
    # These have the duration of the run in them.
    assert set(different) <= {"summary.json", "report.html", "files.json", "results.gpkg"}
    assert summary_without_timings(ours) == summary_without_timings(theirs)
    opened = talus.open_results(theirs)
    for table in ("end_points", "events", "barrier_hits"):
        assert str(getattr(opened, table).tolist()) == str(getattr(result, table).tolist())
    assert list(opened.maps) == list(result.maps)
    for name in result.maps:
        assert (opened.maps[name] == result.maps[name]).all() and opened.maps[name].transform == result.maps[name].transform


def test_a_section_is_that_of_the_program(program, tmp_path):
    file = SOURCE / "examples/maungawhau/maungawhau.toml"
    line = [[330, 120], [335, 80], [360, 40]]
    corners = " ".join(f"{x},{y}" for x, y in line)
    program("section", file, "--line", corners, "--tolerance", 0.05, "-o", tmp_path / "cut.csv")
    cut = talus.prepare(file).surface.section(line, tolerance=0.05)
    rows = [f"{d:.4f},{z:.4f},{x:.4f},{y:.4f}" for d, (x, y, z) in zip(cut.distance, cut.position)]
    assert ["distance_m,z_m,x_m,y_m", *rows] == (tmp_path / "cut.csv").read_text().splitlines()
    project = talus.Project(terrain=talus.Terrain(section=cut.vertices), material=[talus.Material(name="Rock")],
                            seeder=[talus.Seeder(position=[1, "surface"], rocks=1, mass_kg=500)])
    assert talus.prepare(project).surface.elevation(cut.distance) == pytest.approx(cut.position[:, 2])


@pytest.mark.parametrize("case", CASES)
def test_published_cases_have_the_same_bits(case, program, tmp_path):
    file = SOURCE / "verification" / case
    program("run", file, "--rocks", ROCKS, "-o", tmp_path, "-q")
    theirs, ours = talus.open_results(tmp_path), talus.run(file, rocks=ROCKS)
    for table in ("end_points", "events", "barrier_hits"):
        assert str(getattr(theirs, table).tolist()) == str(getattr(ours, table).tolist())
