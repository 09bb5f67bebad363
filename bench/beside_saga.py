#!/usr/bin/env python3
"""Talus beside SAGA's Gravitational Process Path model on one DEM: processor time of whole processes, in turn.

    bench/beside_saga.py PROGRAM [DEM.tif] [--rounds N]

SAGA is Debian's package `saga` (saga_cmd, 8.5); the script needs `python3-rasterio`. Without a DEM, the slope of waves of
the benchmarks is used (rough_slope.hpp: 1025 x 1025 cells of 1 m). A DEM must have square cells of 1 m in a projected
system, and fall towards the east. Rocks start along a line 8 m from the western edge, from 50 m north of the southern edge
to 50 m south of the northern one.

Both write what they write unless told otherwise: SAGA three rasters (process area, maximum velocity, stopping positions)
without compression, Talus all default outputs. What they compute differs: SAGA moves a mass point from cell to cell by a
random walk, slowed by one friction angle; Talus simulates flights, impacts and slides over the triangles between the cells,
with random restitution, and gathers heights, energies and their percentiles in every cell.
"""

import shutil
import statistics
import sys
import tempfile
from pathlib import Path

import numpy as np
import rasterio
from rasterio.transform import from_origin

from whole_process import hash_of_results, measured

SIDE = 1025
NUMBERS_OF_ROCKS = (1_000, 20_000)
PROJECT = """
name = "Beside SAGA"
[terrain]
raster = "dem.tif"
[[material]]
name = "Ground"
normal_restitution = {{ mean = 0.35, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }}
tangential_restitution = {{ mean = 0.85, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }}
friction_angle_deg = 30
[ground]
default = "Ground"
[[seeder]]
type = "line"
points = [[{x}, {south}], [{x}, {north}]]
height_above_m = 6
rocks = 1000
mass_kg = 1000
density_kg_m3 = 2700
speed_m_s = 1.6
direction = [1, 0, 0]
"""


def write_waves(file: Path) -> None:
    """The slope of waves of rough_slope.hpp, with its node (0, 0) in the middle of the south-western cell."""
    y, x = np.mgrid[SIDE - 1 : -1 : -1, 0:SIDE].astype(float)
    z = 0.84 * np.maximum(820 - x, 0)
    amplitude, wave_number = 3.0, 2 * np.pi / 80
    for k in range(6):
        z += amplitude * np.sin(wave_number * x + 1.3 * k) * np.sin(wave_number * y + 2.1 * k)
        amplitude, wave_number = amplitude / 2, wave_number * 2.03
    place = from_origin(-0.5, SIDE - 0.5, 1, 1)
    options = {"driver": "GTiff", "width": SIDE, "height": SIDE, "count": 1, "dtype": "float32", "crs": "EPSG:31287"}
    with rasterio.open(file, "w", transform=place, **options) as out:
        out.write(z.astype("float32"), 1)


def write_releases(dem: Path, file: Path) -> tuple[int, dict[str, float]]:
    """A cell of SAGA's release areas for each metre of the line; returns their number and the line."""
    with rasterio.open(dem) as source:
        bounds, profile, shape = source.bounds, source.profile, source.shape
        line = {"x": bounds.left + 8, "south": bounds.bottom + 50, "north": bounds.top - 50}
        cells = np.full(shape, -99999, dtype="float32")
        first, _ = source.index(line["x"], line["north"] - 0.5)
        last, column = source.index(line["x"], line["south"] + 0.5)
        cells[first : last + 1, column] = 1
    profile.update(dtype="float32", nodata=-99999, count=1)
    with rasterio.open(file, "w", **profile) as out:
        out.write(cells, 1)
    return last + 1 - first, line


def main() -> None:
    arguments = sys.argv[1:]
    rounds = int(arguments.pop(arguments.index("--rounds") + 1)) if "--rounds" in arguments else 3
    program, *dems = [argument for argument in arguments if argument != "--rounds"]
    if shutil.which("saga_cmd") is None:
        sys.exit("saga_cmd is not installed (apt install saga)")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        dem = folder / "dem.tif"
        if dems:
            shutil.copy(dems[0], dem)
        else:
            write_waves(dem)
        cells, line = write_releases(dem, folder / "release.tif")
        project = folder / "project.toml"
        project.write_text(PROJECT.format(**line))
        grids = [f"-{key}={folder / key}.sgrd" for key in ("PROCESS_AREA", "MAX_VELOCITY", "STOP_POSITIONS")]
        print("Seconds of processors; the last column is the time from start to exit on one thread over that on all.")
        print("| rocks | SAGA | Talus | Talus / SAGA | without maps | us a further rock | threads | hash |")
        print("| --- | --- | --- | --- | --- | --- | --- | --- |")
        before = None
        for rocks in NUMBERS_OF_ROCKS:
            walks = max(1, round(rocks / cells))
            count = walks * cells
            saga = ["saga_cmd", "sim_geomorphology", "0", f"-DEM={dem}", f"-RELEASE_AREAS={folder / 'release.tif'}", *grids]
            saga += [f"-GPP_ITERATIONS={walks}", "-FRICTION_MODEL=4", "-FRICTION_ANGLE=30", "-GPP_SEED=1"]
            talus = [program, "run", str(project), "-q", "--rocks", str(count), "-o", str(folder / "out")]
            commands = [saga, [*talus, "--set", "output.maps=false"], [*talus, "--threads", "1"], talus]
            used = [[measured(command) for command in commands] for _ in range(rounds)]
            of_saga, without, one, all_threads = ([each[k] for each in used] for k in range(4))
            processor = [statistics.median(each.processor_s for each in runs) for runs in (of_saga, without, all_threads)]
            speedup = statistics.median(a.seconds / b.seconds for a, b in zip(one, all_threads))
            further = "" if before is None else f"{(processor[2] - before[1]) / (count - before[0]) * 1e6:.0f}"
            before = (count, processor[2])
            print(
                f"| {count} | {processor[0]:.2f} | {processor[2]:.2f} | {processor[2] / processor[0]:.2f} | {processor[1]:.2f} "
                f"| {further} | {speedup:.2f} | {hash_of_results(folder / 'out')} |"
            )


if __name__ == "__main__":
    main()
