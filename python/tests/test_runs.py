"""Runs in memory, and of prepared models."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import talus

from conftest import SLOPE, UNDER_ASAN


def test_a_run_has_its_tables(slope):
    result = talus.run(slope)
    assert result.is_complete and result.rocks == 200
    ends = result.end_points
    assert isinstance(ends, np.ndarray) and len(ends) == 200
    assert ends.dtype.names == tuple(column.name for column in talus.columns("end_points"))
    assert (ends["rock"] == np.arange(200)).all()
    assert set(ends["seeder"]) == {"Crest"} and set(ends["end_reason"]) <= {"at rest", "left the model", "stopped by a barrier"}
    assert (ends["max_ke_J"] > 0).all() and (ends["ensemble"] == -1).all() and np.isnan(ends["lateral_m"]).all()
    events = result.events
    assert set(events["rock"]) == set(range(200)) and events["state"][0] == "projectile"
    hits = result.barrier_hits
    assert set(hits["barrier"]) == {"Fence"} and set(hits["outcome"]) <= {"stopped", "rebounded", "broke through", "passed"}
    assert len(result.impacts) == 0
    assert result.summary["end_reasons"]["at rest"] == (ends["end_reason"] == "at rest").sum()
    envelopes = result.envelopes
    assert (np.diff(envelopes["x_m"]) > 0).all() and envelopes["passages"].max() <= 200
    assert len(result.maps) == 0


def test_tables_are_not_copied_and_outlive_their_results(slope):
    result = talus.run(slope)
    ends = result.end_points
    assert ends.ctypes.data == result._source.table("end_points").ctypes.data
    mean = ends["runout_xy_m"].mean()
    del result
    assert ends["runout_xy_m"].mean() == mean
    with pytest.raises(ValueError):
        ends["runout_xy_m"][0] = 1


def test_results_do_not_depend_on_threads(slope):
    one, two = (talus.run(slope, threads=threads) for threads in (1, 2))
    assert one.end_points.tobytes() == two.end_points.tobytes() and one.events.tobytes() == two.events.tobytes()


def test_a_prepared_model_runs_with_other_settings(slope):
    model = talus.prepare(slope)
    for change in (
        {"material": {"Scree": {"normal_restitution": 0.2, "tangential_restitution": talus.Normal(0.8, 0.02)}}},
        {"material": {"Rock": {"friction_angle_deg": 35}}, "seed": 7},
        {"analysis": {"model": "rigid_sphere"}},
        {"barrier": {"Fence": {"capacity_kJ": 1}}},
        {"seeder": {"Crest": {"mass_kg": 900, "horizontal_velocity_m_s": 4}}},
        {"barrier": {"Fence": {"height_m": 0.5}}},
        {"rocks": 77, "seeder": {"Crest": {"position": [3, "surface"]}}},
        {"output": {"paths": 10}, "sampling": {"method": "latin_hypercube"}},
    ):
        ours, fresh = model.run(**change), talus.run(slope.changed(**change))
        assert ours.end_points.tobytes() == fresh.end_points.tobytes()
        assert ours.barrier_hits.tobytes() == fresh.barrier_hits.tobytes()
        assert ours.summary["fingerprint"] == fresh.summary["fingerprint"]
    with pytest.raises(talus.BadInput, match="terrain is read once"):
        model.run(terrain={"section": [[0, 1], [1, 0]]})


def test_settings_can_be_named_by_paths(slope):
    model = talus.prepare(slope)
    by_table = model.run(material={"Scree": {"normal_restitution": 0.2}})
    by_path = model.run(**{"material.Scree.normal_restitution": 0.2})
    assert by_table.end_points.tobytes() == by_path.end_points.tobytes()


def test_a_model_can_be_used_by_several_threads(slope):
    model = talus.prepare(slope)
    values = [0.2, 0.3, 0.4, 0.5]
    expected = [model.run(material={"Scree": {"normal_restitution": value}}).end_points.tobytes() for value in values]
    found = [None] * len(values)

    def work(k):
        for _ in range(3):
            found[k] = model.run(material={"Scree": {"normal_restitution": values[k]}}).end_points.tobytes()

    threads = [threading.Thread(target=work, args=(k,)) for k in range(len(values))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == expected


@pytest.mark.skipif(UNDER_ASAN, reason="the sanitizer holds freed memory back")
def test_many_runs_leak_nothing(slope):
    model = talus.prepare(slope)

    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    for _ in range(30):
        model.run(rocks=50).summary
    before = resident()
    for _ in range(150):
        model.run(rocks=50, seed=3).summary
    assert resident() - before < 8e6  # a run has a third of a megabyte


def test_progress_is_told(slope):
    seen = []
    talus.run(slope, progress=lambda done, planned: seen.append((done, planned)))
    assert seen[-1] == (200, 200) and sorted(seen) == seen

    def fail(done, planned):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        talus.run(slope, progress=fail)


def test_the_lock_is_released(slope):
    """Another thread counts while a run is under way."""
    model, counts, end = talus.prepare(slope), [0], threading.Event()

    def count():
        while not end.is_set():
            counts[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    model.run(rocks=20000, output={"paths": "none", "trajectories_MB": 0})
    during = counts[0]
    end.set()
    thread.join()
    assert during > 0


def test_control_c_stops_and_keeps():
    """A process of its own gets the signal."""
    code = f"""
import os, signal, talus
project = talus.Project.from_text({SLOPE!r}, rocks=3_000_000, output={{"paths": "none", "trajectories_MB": 0}})
def interrupt(done, planned):
    os.kill(os.getpid(), signal.SIGINT)
try:
    talus.run(project, progress=interrupt)
except talus.Interrupted as stopped:
    result = stopped.result
    assert 0 < result.rocks_done < result.rocks and not result.is_complete
    assert len(result.end_points) == result.rocks_done and result.summary["interrupted"]
    print("kept")
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert process.stdout == "kept\n", process.stderr


def test_the_interpreter_ends_while_rocks_are_simulated():
    code = f"""
import talus, threading, time
model = talus.prepare(talus.Project.from_text({SLOPE!r}, rocks=3_000_000, output={{"paths": "none", "trajectories_MB": 0}}))
begun = threading.Event()
threading.Thread(target=lambda: model.run(progress=lambda *_: begun.set()), daemon=True).start()
begun.wait()
print("ends")
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert (process.returncode, process.stdout) == (0, "ends\n"), process.stderr


def test_a_process_forked_during_a_run_refuses_rocks(slope):
    code = f"""
import os, talus, threading
model = talus.prepare(talus.Project.from_text({SLOPE!r}, rocks=3_000_000, output={{"paths": "none", "trajectories_MB": 0}}))
begun = threading.Event()
threading.Thread(target=lambda: model.run(progress=lambda *_: begun.set()), daemon=True).start()
begun.wait()
child = os.fork()
if child == 0:
    try:
        model.run(rocks=5, threads=1)
    except RuntimeError as error:
        os._exit(7 if "spawn" in str(error) else 1)
    os._exit(2)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert (process.returncode, process.stdout) == (0, "7\n"), process.stderr


def test_flights_with_drag_are_the_closed_form():
    k, v = 5.0, np.array([3.0, 0, 4])
    place, velocity = talus.flight.at([0, 0, 0], v, [0.1, 10, 1000], drag_rate=k)
    for t, z, vz in zip([0.1, 10, 1000], place[:, 2], velocity[:, 2]):
        gone, g = -np.expm1(-k * t) / k, talus.flight.standard_gravity
        assert z == pytest.approx(4 * gone - g * (t - gone) / k, rel=1e-12)
        assert vz == pytest.approx(4 * np.exp(-k * t) - g * gone, rel=1e-12)


def test_one_rock_can_be_followed(slope):
    result = talus.run(slope)
    path = talus.follow(slope, rock=7)
    rows = result.events[result.events["rock"] == 7]
    assert path.events.tobytes() == rows.tobytes()
    end = result.end_points[7]
    assert (path.duration, path.mass, path.end_reason) == (end["time_s"], end["mass_kg"], end["end_reason"])
    at = path.at(rows["time_s"])
    assert np.allclose(at.position[:, 0], rows["x_m"], atol=1e-9)
    assert np.allclose(at.position[:, 2], rows["z_m"], atol=1e-9)
    fine = path.at(np.linspace(-1, path.duration + 1, 500))
    steps = np.linalg.norm(np.diff(fine.position, axis=0), axis=1)
    assert steps.max() < 1.1 * np.linalg.norm(fine.velocity, axis=1).max() * (path.duration + 2) / 499
    with pytest.raises(talus.BadInput, match="^rock=200: there is no such rock"):
        talus.follow(slope, rock=200)


def test_how_a_block_is_turned_is_known_at_any_time(tmp_path):
    project = talus.Project(
        folder=tmp_path, analysis=talus.Analysis(model="rigid_body"),
        terrain=talus.Terrain(section=[[0, 60], [80, 0], [400, 0]], width_m=200),
        shape=[talus.Shape.box(1.2, 0.9, 0.6, name="slab")],
        material=[talus.Material(name="Scree", normal_restitution=0.35, dynamic_friction=0.6)],
        seeder=[talus.Seeder(name="Crest", position=[2, 100], height_above_m=3, mass_kg=1500, rocks=20, shape="slab")],
        output=talus.Output(report=False))
    result = talus.run(project)
    assert np.all(result.end_points["short_axis_share"] >= 0) and np.all(result.end_points["short_axis_share"] <= 1)
    assert np.allclose(result.end_points["b_m"] / result.end_points["a_m"], 0.9 / 1.2)
    path = talus.follow(project, rock=3)
    events = path.events
    given = np.stack([events[name] for name in ("qw", "qx", "qy", "qz")], axis=1)
    turns = path.orientation
    assert turns.shape == (len(events), 4)
    assert np.allclose(np.linalg.norm(turns, axis=1), 1)
    # The same orientation, of either sign, but on the ground, where it turns on in steps.
    flown = events["state"] == "projectile"
    assert np.allclose(np.abs(np.sum(turns * given, axis=1))[flown], 1, atol=1e-9)
    block = path.block
    assert block.corners.shape == (8, 3) and block.triangles.shape[1] == 3 and block.moments.shape == (3,)
    assert np.prod(np.ptp(block.corners, axis=0)) == pytest.approx(path.mass / 2700)

    def lowest(k):
        w, v = turns[k, 0], turns[k, 1:]
        t = 2 * np.cross(v, block.corners)
        corners = block.corners + w * t + np.cross(v, t) + [events[axis][k] for axis in ("x_m", "y_m", "z_m")]
        ground = np.where(corners[:, 0] < 80, 60 - 0.75 * corners[:, 0], 0)
        return np.min(corners[:, 2] - ground)

    struck = np.flatnonzero(events["state"] == "impact")
    assert len(struck) > 3
    gaps = [lowest(k) for k in struck]
    assert np.max(np.abs(gaps[:4])) < 1e-6
    assert max(gaps) < 2e-3
    assert min(gaps) > -0.04  # in steps on the ground corners sink in by up to centimetres
    assert path.orientation_at(0.1).shape == (4,)
    sphere = talus.follow(project.changed(analysis={"model": "rigid_sphere"}), rock=3)
    assert sphere.orientation is None and sphere.block is None
