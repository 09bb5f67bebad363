"""Lines, polygons and ditches, and what if: the answers of the program."""

import csv
import io
import json
import math
import subprocess
import sys

import numpy as np
import pytest

import talus

from conftest import SLOPE, SOURCE

VOLCANO = SOURCE / "examples/maungawhau/maungawhau.toml"
LINE = [[300, 70], [400, 60]]
POLYGON = [[300, 20], [400, 20], [400, 60], [300, 60]]


@pytest.fixture(scope="module")
def volcano():
    return talus.run(VOLCANO, rocks=400)


@pytest.fixture(scope="module")
def in_folder(volcano, tmp_path_factory):
    """The same run as a folder, of which the program can ask."""
    return volcano.save(tmp_path_factory.mktemp("volcano") / "out")


def text_of(corners):
    return " ".join(f"{x},{y}" for x, y in corners)


def program_says(program, folder, *question):
    file = folder.parent / "answer.json"
    program("line", folder, *question, "--files", VOLCANO.parent, "--json", file)
    return json.loads(file.read_text())


def test_a_line_is_that_of_the_program(volcano, in_folder, program):
    theirs = program_says(program, in_folder, "--line", text_of(LINE), "--height", 3, "--energy", 500)
    ours = volcano.line(LINE, height=3, energy=500)
    assert ours.json == theirs
    again = talus.open_results(in_folder, files=VOLCANO.parent).line(np.array(LINE), height=3, energy=500)
    assert again.json == theirs
    assert (again.crossing_rocks == ours.crossing_rocks).all() and len(ours.crossing_rocks) == ours.crossing > 20


def test_a_polygon_is_that_of_the_program(volcano, in_folder, program):
    ours = volcano.polygon(POLYGON)
    assert ours.json == program_says(program, in_folder, "--polygon", text_of(POLYGON))
    assert ours.entering == len(ours.entering_rocks) >= ours.stopping
    assert ours.entering_share.low < ours.entering_share.value < ours.entering_share.high
    assert ours.percentile("ke_total_J", 95).value == ours.json["percentiles"]["ke_total_J"]["95"][0]
    assert math.isnan(ours.percentile("ke_total_J", 12).value)


def test_the_figures_of_a_line(volcano):
    answer = volcano.line(LINE, height=3, energy=500)
    assert (answer.rocks, answer.percentile, answer.confidence, answer.energy_kind) == (400, 95, 0.95, "translational")
    assert answer.share.value == answer.crossing / 400
    for figure in (answer.share, answer.energy_kJ, answer.height_m, answer.velocity_m_s):
        assert figure.low <= figure.value <= figure.high
    assert f"{answer.energy_kJ.value:.3g}" in answer.json["card"]["energy"]
    assert answer.foot.shape[1] == 3 and answer.length_m == pytest.approx(math.hypot(100, 10))
    needs = answer.json["whole"]["needs"]
    assert answer.needs == (needs["class"], needs["energy_J"] / 1000, needs["height_m"])
    assert answer.needs.energy_kJ > answer.energy_kJ.value and answer.needs.height_m > answer.height_m.value  # factors
    profile = answer.profile
    assert profile["rocks"].sum() == answer.crossing and profile["to_m"][-1] == pytest.approx(answer.length_m)
    busy = profile["rocks"] > 0
    assert np.isfinite(profile["energy_kJ"][busy]).all() and np.isnan(profile["energy_kJ"][~busy]).all()
    assert answer.kit.stopped + answer.kit.above + answer.kit.through == answer.crossing
    sources = answer.sources
    assert sources["crossing"].sum() == answer.crossing and (sources["clearing"] <= sources["crossing"]).all()
    assert answer.ensembles is None and "rocks cross" in repr(answer) and "<table>" in answer._repr_html_()
    other = volcano.line(LINE, design={"standard": "none", "design_percentile": 50})
    assert (other.percentile, other.standard) == (50, "") and other.energy_kJ.value < answer.energy_kJ.value


def test_ensembles_have_a_range(slope, tmp_path):
    sets = tmp_path / "sets.csv"
    sets.write_text("\n".join(["material.*.tangential_restitution.mean", *(f"{0.6 + 0.03 * k:.2f}" for k in range(10))]))
    results = talus.run(slope, sampling={"parameters": str(sets), "ensembles": 10})
    found = results.line([[15, 0]]).ensembles
    assert (found.ensembles, found.confidence) == (10, 0.9) and found.crossing <= 10
    for each in (found.share, found.energy_total_kJ, found.height_m, found.needs_energy_kJ):
        assert each.low <= each.value <= each.high
    assert math.isnan(found.stopping_share.value)


def test_a_line_that_no_rock_crosses(volcano):
    none = volcano.line([[20, 20], [30, 20]])
    assert none.crossing == 0 and none.share.value == 0 and math.isnan(none.energy_kJ.value) and none.needs is None
    assert repr(none) and str(none.energy_kJ) == "unknown"


def test_lines_as_users_have_them(volcano, tmp_path):
    shapely = pytest.importorskip("shapely.geometry")
    expected = volcano.line(LINE).json
    assert volcano.line(shapely.LineString(LINE)).json == expected
    assert volcano.line(shapely.LineString([(*corner, 7) for corner in LINE])).json == expected
    assert volcano.line(text_of(LINE)).json == expected
    table = tmp_path / "line.csv"
    table.write_text("x_m,y_m\n" + "\n".join(f"{x},{y}" for x, y in LINE))
    assert volcano.line(table).json == expected
    assert volcano.polygon(shapely.Polygon(POLYGON)).json == volcano.polygon(POLYGON).json
    with pytest.raises(talus.BadInput, match="^line is a Polygon .expected a LineString"):
        volcano.line(shapely.Polygon(POLYGON))


def test_a_section_is_asked_at_places(slope):
    result = talus.run(slope)
    at = result.line(35)
    fence = result.line(barrier="Fence")
    assert at.crossing > 0 and fence.name == "Fence" and at.name == "" and (at.foot[:, 0] == 35).all()
    ditch = result.ditch(40, 60)
    assert 0 < ditch.arriving <= 200 and ditch.inside + ditch.beyond <= 200 and "past the toe" in repr(ditch)


def test_files_are_the_same_after_a_question(slope, tmp_path):
    asked, plain = talus.run(slope), talus.run(slope)
    asked.line(35)
    store = [(each.save(tmp_path / name) / "trajectories.bin").read_bytes()
             for name, each in (("asked", asked), ("plain", plain))]
    assert store[0] == store[1]


def test_what_if_is_that_of_the_program(program, tmp_path):
    program("what-if", VOLCANO, "--rocks", 300, "--line", text_of(LINE), "--step",
            "normal_restitution=10%", "--step", "mass=50%", "-o", tmp_path, "-q")
    project = talus.Project.read(VOLCANO, rocks=300)
    seen = []
    answer = talus.what_if(project, LINE, steps={"normal_restitution": 0.1, "mass": 0.5},
                           progress=lambda done, planned: seen.append((done, planned)))
    assert answer.json == json.loads((tmp_path / "what_if.json").read_text())
    assert (answer.rocks, answer.planned) == (300, 300) and seen[-1] == (300, 300)
    assert [(each.factor, each.step) for each in answer.variations] == [
        ("normal_restitution", -0.1), ("normal_restitution", 0.1), ("mass", -0.5), ("mass", 0.5)]
    heavier = answer.variations[3]
    assert heavier.change.energy_kJ.value == pytest.approx(heavier.figures.energy_kJ.value - answer.base.energy_kJ.value)
    line = talus.run(project).line(LINE)
    assert (answer.base.share, answer.base.needs, answer.standard) == (line.share, line.needs, line.standard)
    assert heavier.figures.needs.energy_kJ > answer.base.needs.energy_kJ and heavier.change.needs is None
    assert f"{heavier.figures.needs.height_m:.2f} m" in answer._repr_html_()
    assert "variations" in repr(answer) and "<table>" in answer._repr_html_()
    pytest.importorskip("pandas")
    frame, rows = answer.to_pandas(), list(csv.DictReader(io.StringIO((tmp_path / "what_if.csv").read_text())))
    assert list(frame.columns) == list(rows[0]) and list(frame["factor"]) == [row["factor"] for row in rows]
    assert frame["needs_mel_kJ"][4] == pytest.approx(heavier.figures.needs.energy_kJ)
    assert frame["energy_change_J"][0] != frame["energy_change_J"][0]  # NaN: of the base
    assert frame["energy_change_J"][4] == float(rows[4]["energy_change_J"])


def test_what_if_takes_a_model_and_places_of_all_kinds(slope):
    model = talus.prepare(slope)
    assert talus.what_if(model, barrier="Fence", steps={"mass": 0.2}, rocks=64).rocks == 64
    assert talus.what_if(slope, 35, material="Scree").variations
    models = talus.what_if(slope, steps={}, models=True, rocks=64)
    assert {each.factor for each in models.variations} == {"model"} and models.variations[0].step is None
    assert models.base.runout_m.value > 0 and math.isnan(models.base.energy_kJ.value)
    assert "sphere" in models._repr_html_()
    volcano = talus.Project.read(VOLCANO, rocks=50)
    assert talus.what_if(volcano, polygon=POLYGON, steps={"mass": 0.2}).base.height_m.value >= 0
    assert talus.what_if(volcano, polygon=POLYGON, steps={"mass": 0.2}, rocks=64).base.needs is None


def test_control_c_keeps_the_rocks_of_a_what_if():
    code = f"""
import os, signal, talus
project = talus.Project.from_text({SLOPE!r}, rocks=3_000_000)
def interrupt(done, planned):
    os.kill(os.getpid(), signal.SIGINT)
try:
    talus.what_if(project, 35, progress=interrupt)
except talus.Interrupted as stopped:
    assert 0 < stopped.result.rocks < stopped.result.planned, stopped.result
    print("kept")
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=240)
    assert process.stdout == "kept\n", process.stderr
