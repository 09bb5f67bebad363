#!/usr/bin/python3
"""What the Python package adds to the engine: PYTHONPATH=build/python bench/python.py [RUNS]

Time per run of a prepared model beyond its rocks, the time of a million end points as an array, a campaign beside the
program, and many runs on a DEM of a million cells with the memory that they take.
"""

import hashlib
from pathlib import Path
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

import talus

FEW = {"paths": "none", "trajectories_MB": 0, "maps": False, "report": False}
examples = Path(__file__).parent.parent / "examples"
folder = Path(tempfile.mkdtemp())


def best(work, times=5):
    """The least duration [s] of some calls."""
    durations = []
    for _ in range(times):
        begin = time.perf_counter()
        work()
        durations.append(time.perf_counter() - begin)
    return min(durations)


def hash_of(array):
    return hashlib.sha256(np.ascontiguousarray(array)).hexdigest()[:12]


def overhead(name, model, **settings):
    """Per run beyond the rocks: a run of one rock, with all that a run of many has."""
    def many():
        for value in np.linspace(0.3, 0.4, 100):
            model.run(threads=1, material={"0": {"normal_restitution": value}}, **settings)

    print(f"{name}: {best(many) / 100 * 1000:.3f} ms a run with other values of a material")


def million():
    model = talus.prepare(examples / "tutorial-1/tutorial-1-2d.toml")
    begin = time.perf_counter()
    result = model.run(rocks=1_000_000, output=FEW)
    seconds = time.perf_counter() - begin
    array = best(lambda: result._source.table("end_points"))
    print(f"a million rocks: {seconds:.2f} s, of which {result._source.seconds:.2f} s rocks; their end points as an "
          f"array: {array * 1000:.3f} ms; hash {hash_of(result.end_points)}")
    begin = time.perf_counter()
    result.frame("end_points")
    print(f"as a frame: {time.perf_counter() - begin:.2f} s")


def beside_the_program(program, rocks=200_000):
    file = examples / "tutorial-1/tutorial-1-2d.toml"
    few = [text for key, value in FEW.items() for text in ("--set", f"output.{key}={str(value).lower()}")]
    theirs = best(lambda: subprocess.run([program, "run", file, "--rocks", str(rocks), *few, "-q", "-o", folder / "program"],
                                         check=True), 3)
    ours = best(lambda: talus.run(file, rocks=rocks, output=FEW).save(folder / "package"), 3)
    print(f"{rocks} rocks into a folder: program {theirs:.2f} s, package {ours:.2f} s")


def dem(runs, cells=1000):
    """A wavy slope of a million cells."""
    x, y = np.meshgrid(np.arange(cells + 1), np.arange(cells + 1))
    z = 1000 - 0.7 * y + 3 * np.sin(x / 17) * np.cos(y / 23)
    with open(folder / "dem.asc", "w") as file:
        file.write(f"ncols {cells + 1}\nnrows {cells + 1}\nxllcenter 0\nyllcenter 0\ncellsize 2\n")
        np.savetxt(file, z, fmt="%.3f")
    project = talus.Project(
        folder=folder, terrain=talus.Terrain(raster="dem.asc", crs="local"), material=[talus.Material(name="Ground")],
        seeder=[talus.Seeder(type="line", points=[[500, 1900], [1500, 1900]], height_above_m=1, rocks=1000, mass_kg=500)])
    begin = time.perf_counter()
    model = talus.prepare(project)
    print(f"a million cells: prepared in {time.perf_counter() - begin:.2f} s")
    overhead("a million cells, one rock", talus.prepare(project.changed(rocks=1)), output=FEW)
    first = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    begin, rocks = time.perf_counter(), 0.0
    for k in range(runs):
        result = model.run(material={"0": {"normal_restitution": 0.3 + 0.1 * k / runs}}, output=FEW)
        rocks += result._source.seconds
    seconds = time.perf_counter() - begin
    print(f"a million cells: {runs} runs of a thousand rocks in {seconds:.1f} s, {rocks:.1f} s of it rocks: "
          f"{(seconds - rocks) / runs * 1000:.3f} ms a run beyond them; memory grew by "
          f"{(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - first) / 1024:.1f} MB; hash {hash_of(result.end_points)}")


tutorial = examples / "tutorial-1/tutorial-1-2d.toml"
overhead("a section, one rock", talus.prepare(talus.Project.read(tutorial, rocks=1)))
overhead("a section, one rock, end points alone", talus.prepare(talus.Project.read(tutorial, rocks=1)), output=FEW)
million()
beside_the_program(Path(talus.__file__).parent.parent.parent / "talus")
dem(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
