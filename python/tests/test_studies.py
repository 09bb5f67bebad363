"""Calibrations and sensitivity studies: the files are those of the program."""

import filecmp
import shutil
import subprocess
import sys

import pytest

import talus

from conftest import SOURCE

pytest.importorskip("pandas")

STUDY = """rocks = 60
draws = 60
rounds = 2
most_draws = 60
[[site]]
project = "slope.toml"
[[observations]]
stops = "stops.csv"
[[parameter]]
path = "material.Scree.tangential_restitution"
range = [0.6, 0.95]
[[parameter]]
path = "material.Scree.roughness_deg"
range = [1, 15]
"""
MODELS = STUDY.replace("rocks = 60", "rocks = 40\nfolds = 2") + """
[[model]]
name = "as it is"
[[model]]
name = "smooth"
set = ["analysis.grazing_angle_deg=5"]
"""
SENSITIVITY = """rocks = 20
trajectories = 4
[[site]]
project = "slope.toml"
[[parameter]]
path = "material.Scree.tangential_restitution"
range = [0.6, 0.95]
[[result]]
quantity = "runout"
percentile = 50
"""


@pytest.fixture
def site(tmp_path):
    for name in ("slope.toml", "stops.csv"):
        shutil.copy(SOURCE / "examples/calibration" / name, tmp_path)

    def write(text):
        (tmp_path / "study.toml").write_text(text)
        return tmp_path / "study.toml"

    return write


def test_a_calibration_is_that_of_the_program(site, program, tmp_path):
    study, seen = site(STUDY), []
    program("calibrate", study, "-o", tmp_path / "theirs", "-q")
    found = talus.calibrate(study, progress=lambda done, planned: seen.append((done, planned)))
    assert found.folder == tmp_path / "study" and seen[-1][0] == seen[-1][1] >= 60
    for name in ("posterior.csv", "sets.csv"):
        assert filecmp.cmp(found.folder / name, tmp_path / "theirs" / name, shallow=False)
    assert found.posterior["weight"].sum() == pytest.approx(1) and len(found.sets) >= 60
    parameter = found.parameters.loc["material.Scree.tangential_restitution"]
    assert 0.6 <= parameter["p05"] <= parameter["p50"] <= parameter["p95"] <= 0.95
    (best,) = found.best.values()
    assert talus.run(best, rocks=5).rocks == 5
    assert found.report.exists() and "<table" in found._repr_html_() and str(found.folder) in repr(found)


def test_models_of_a_study_are_compared(site):
    found = talus.calibrate(site(MODELS))
    assert list(found) == ["as it is", "smooth"] and all(len(each.posterior) for each in found.values())
    assert (found["as it is"].folder.parent / "models.csv").exists()


def test_a_sensitivity_study_is_that_of_the_program(site, program, tmp_path):
    study, seen = site(SENSITIVITY), []
    program("sensitivity", study, "-o", tmp_path / "theirs", "-q")
    found = talus.sensitivity(study, folder=tmp_path / "ours", progress=lambda done, planned: seen.append((done, planned)))
    for name in ("sensitivity.csv", "runs.csv"):
        assert filecmp.cmp(found.folder / name, tmp_path / "theirs" / name, shallow=False)
    assert seen[-1][0] == seen[-1][1] == len(found.runs)
    assert "material.Scree.tangential_restitution" in set(found.effects["input"]) and found.summary and found.report.exists()


def test_wrong_studies(site, tmp_path):
    with pytest.raises(talus.BadInput, match="there is no such file"):
        talus.calibrate(tmp_path / "none.toml")
    with pytest.raises(talus.BadInput):
        talus.sensitivity(site(STUDY))
    with pytest.raises(talus.BadInput, match="^threads=-1"):
        talus.calibrate(site(STUDY), threads=-1)


def test_control_c_ends_a_calibration_that_goes_on_later(site):
    study = site(STUDY)
    code = f"""
import os, signal, talus
def interrupt(done, planned):
    os.kill(os.getpid(), signal.SIGINT)
try:
    talus.calibrate({str(study)!r}, progress=interrupt)
except KeyboardInterrupt:
    print("stopped")
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=240)
    assert process.stdout == "stopped\n", process.stderr
    assert len(talus.calibrate(study).posterior) > 0
