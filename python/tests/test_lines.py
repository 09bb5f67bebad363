"""Lines, polygons and ditches, and what if: the answers of the program."""

import csv
from html import escape
import io
import json
import math
import subprocess
import sys

import numpy as np
import pytest

import talus
from talus import texts

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
    assert answer.ensembles is None
    assert len(answer.frame("sources")) == len(sources) and list(answer.frame()["rocks"]) == list(profile["rocks"])
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
    total = found.energy_total_kJ
    row = f"95 % energy there, total          {total.value:.1f} kJ"
    assert row in repr(found) and f"{total.low:.1f} to {total.high:.1f} kJ" in repr(found)
    assert row in repr(results.line([[15, 0]])) and "90 % of the run's 10 ensembles" in repr(results.line([[15, 0]]))
    frame = found.frame().set_index("figure")
    assert frame.loc["energy_total_kJ", "low"] == total.low and "stopping_share" not in frame.index


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
    assert str(heavier.figures.needs) in answer._repr_html_() and "normal restitution +10 %" in answer._repr_html_()
    assert "in each of 5 sets, own rock model lumped mass" in repr(answer)
    pytest.importorskip("pandas")
    frame, rows = answer.frame(), list(csv.DictReader(io.StringIO((tmp_path / "what_if.csv").read_text())))
    assert list(frame.columns) == ["name", "factor", "model", *list(rows[0])[1:]]
    assert list(frame["factor"]) == [row["factor"] for row in rows] and set(frame["model"]) == {"lumped_mass"}
    assert list(frame["name"]) == ["own values", "normal restitution -10 %", "normal restitution +10 %", "mass -50 %", "mass +50 %"]
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
    assert [(each.name, each.model) for each in models.variations] == [
        ("rigid sphere", "rigid_sphere"), ("rigid body (rectangle 5 6)", "rigid_body")]
    assert "95 % runout" in repr(models) and "Passes" not in repr(models)
    volcano = talus.Project.read(VOLCANO, rocks=50)
    assert talus.what_if(volcano, polygon=POLYGON, steps={"mass": 0.2}).base.height_m.value >= 0
    assert talus.what_if(volcano, polygon=POLYGON, steps={"mass": 0.2}, rocks=64).base.needs is None


def test_ranges_know_their_ends(slope):
    answer = talus.what_if(slope, 30, steps={"mass": 0.5}, models=True, rocks=200)
    light, heavy = answer.variations[2:]
    inputs = answer.inputs_range()
    assert (inputs.low, inputs.high) == (light.figures.energy_kJ, heavy.figures.energy_kJ)
    assert (inputs.at_low, inputs.at_high) == (light, heavy) and inputs.low.low < inputs.low.value < inputs.low.high
    assert f"highest with mass +50 % ({heavy.figures.energy_kJ.low:.0f} to" in str(inputs)
    of_models = {"own": answer.base, **{each.name: each.figures for each in answer.variations[:2]}}
    for figure in ("energy_kJ", "share", "needs_height_m", "runout_m"):
        models, values = answer.models_range(figure), {name: getattr(of, figure).value for name, of in of_models.items()}
        assert (models.low.value, models.high.value) == (min(values.values()), max(values.values()))
        assert values[models.at_high.name if models.at_high else "own"] == models.high.value
    assert answer.inputs_range("velocity_m_s").at_low is answer.inputs_range("velocity_m_s").at_high is None  # mass alone
    needs = answer.models_range("needs_energy_kJ").high
    assert math.isnan(needs.low) and needs.high > needs.value  # a fence is needed up to its upper end
    assert math.isnan(answer.models_range("needs_class").chance[0])
    assert inputs.chance == (light.figures.energy_kJ.low, heavy.figures.energy_kJ.high)
    of_share = [of.share for of in of_models.values()]
    assert answer.models_range("share").chance == (min(each.low for each in of_share), max(each.high for each in of_share))
    classes = [of.needs.kit_class for of in of_models.values()]
    assert set(classes) == {1} and str(answer.models_range("needs_class")).startswith("1 in each, ")
    further = talus.what_if(slope, 35, steps={"mass": 0.5}, rocks=200)
    assert [each.figures.needs.kit_class for each in further.variations] == [0, 2]
    assert str(further.inputs_range("needs_class")).startswith("0 to 2, lowest with mass -50 % (up to 0), highest with ")
    assert str(answer.inputs_range("share")).startswith("100 % in each, ")
    assert answer.base.energy_translational_kJ == answer.base.energy_kJ != answer.base.energy_total_kJ
    alone = talus.what_if(slope, 30, steps={"mass": 0.5}, rocks=64)
    assert alone.models_range() is None and "not varied" in repr(alone)
    nobody = talus.what_if(slope, 99, steps={"mass": 0.5}, rocks=64)
    assert nobody.inputs_range() is None and nobody.inputs_range("share").high.value == 0
    assert repr(nobody).splitlines()[2].split()[-6:] == ["none", "–", "none", "crosses", "not", "varied"]
    with pytest.raises(talus.BadInput, match="^figure='energy_J': expected share, energy_kJ.* Did you mean"):
        answer.inputs_range("energy_J")


def test_answers_say_their_figures_with_units(volcano, slope):
    answer = volcano.line(LINE, height=3, energy=500)
    share, total, height, upper = answer.share, answer.energy_total_kJ, answer.height_m, answer.needs_at_upper_end
    for row in (("Passes the line", f"{100 * share.value:.1f} %", f"{100 * share.low:.1f} to {100 * share.high:.1f} %"),
                ("95 % energy there, total", f"{total.value:.0f} kJ", f"{total.low:.0f} to {total.high:.0f} kJ"),
                ("95 % height of the block's top", f"{height.value:.2f} m", f"{height.low:.2f} to {height.high:.2g} m"),
                ("Fence needed, class", f"{answer.needs.kit_class}", f"up to {upper.kit_class}"),
                ("Fence needed, energy", f"{answer.needs.energy_kJ:.0f} kJ",
                 f"up to {upper.energy_kJ:.0f} kJ")):
        assert " ".join(row) in " ".join(repr(answer).split()), row
        assert all(escape(cell, quote=True) in answer._repr_html_() for cell in row)
    needs = [row["needs"] or {"energy_J": 0, "height_m": 0} for row in answer.json["sections"]]
    energies, heights = ([row[key] for row in needs] for key in ("energy_J", "height_m"))
    worst, highest = answer.worst, answer.highest
    assert worst.needs.energy_kJ == max(energies) / 1000 and worst.rocks == answer.profile["rocks"][np.argmax(energies)]
    assert highest.needs.height_m == max(heights) and highest.from_m == answer.profile["from_m"][np.argmax(heights)]
    assert "166 of 400 rocks. Fence: UNI 11211-4, with γ" in repr(answer)
    assert f"\nMost energy: {worst.from_m:.0f}" in repr(answer) and f", {highest.rocks} rocks.\n3 m and 500 kJ here stop" in repr(answer)
    bare = volcano.line(LINE, design={"standard": "none"})
    assert "Fence needed, energy" in repr(bare) and "class" not in repr(bare) and "no factors are applied" in repr(bare)
    inside = volcano.polygon(POLYGON)
    energy = talus.Estimate(*(each / 1000 for each in inside.percentile("ke_total_J", 95)))
    assert f"95 % energy there, total {energy.value:.0f} kJ {energy.low:.0f} to {energy.high:.0f} kJ" in " ".join(repr(inside).split())
    assert f"Stops in the polygon {100 * inside.stopping_share.value:.1f} %" in " ".join(repr(inside).split())
    assert list(inside.frame()["value"]) == list(inside.percentiles["value"])
    ditch = talus.run(slope).ditch(40, 60)
    assert list(ditch.frame()["rocks"]) == [ditch.arriving, ditch.inside, ditch.beyond]


@pytest.mark.parametrize("value, text", [
    (0.5, "50 %"), (0.4932, "49.3 %"), (1, "100 %"), (0.9999, "99.99 %"), (0.00001, "0.001 %"),
    (1905 / 2000, "95.3 %"), (201 / 400, "50.3 %"), (23 / 80, "28.8 %"), (0.1245, "12.5 %")])
def test_shares_are_texts(value, text):
    assert texts.percent_text(value) == text


@pytest.mark.parametrize("estimate, text", [
    ((1234.4, 1100, 1400.2), "1,234 kJ (1,100 to 1,400 kJ)"), ((0.0712, 0.05, math.nan), "0.0712 kJ (0.05 kJ or more)"),
    ((2, math.nan, 3), "2 kJ (up to 3 kJ)"), ((2.4, math.nan, math.nan), "2.4 kJ (too few rocks)"), ((math.nan,) * 3, "none")])
def test_figures_are_texts(estimate, text):
    assert texts.estimate_text("energy_kJ", talus.Estimate(*estimate)) == text


def test_changes_are_texts():
    assert texts.change_text("share", talus.Estimate(-0.0168, -0.02, 0.01)) == "-1.68 (-2 to +1) % points"
    assert texts.change_text("height_m", talus.Estimate(0.12345, math.nan, math.nan)) == "+0.123 m"
    assert texts.change_text("height_m", talus.Estimate(-1e-9, 0, 0.00042)) == "0 (0 to +0.0004) m"


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
