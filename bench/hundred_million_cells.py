#!/usr/bin/env python3
"""A DEM of 10^8 cells of 1 m, and a million rocks from its steep cells with all default outputs.

    bench/hundred_million_cells.py PROGRAM [--side NODES] [--rocks N]
    bench/hundred_million_cells.py --write FOLDER [--side NODES] [--rocks N]

The second only writes the project, FOLDER/run.toml. Needs NumPy, GDAL for Python, some 8 GB of memory and
2 GB of disk.
"""

import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from osgeo import gdal, osr
from whole_process import hash_of_results, measured

STEEP = np.float32(np.tan(np.radians(50)))
PROJECT = """[terrain]
raster = "dem.tif"
[[material]]
name = "Scree"
like = "talus_cover"
[[seeder]]
type = "raster"
min_slope_deg = 50
rocks = {rocks}
diameter_m = 0.8
"""


def mountains(side: int) -> np.ndarray:
    """Elevations [m] with a spectrum of power -4.1 below 4 km, of which 6 % are steeper than 50 degrees."""
    random = np.random.default_rng(1)
    waves = np.hypot(np.fft.rfftfreq(side)[None, :], np.fft.fftfreq(side)[:, None]).astype(np.float32)
    waves[0, 0] = 1
    size = waves**-2.05 * np.minimum(1, waves * 4000) ** 2
    size[0, 0] = 0
    phase = random.random(waves.shape, dtype=np.float32) * np.float32(2 * np.pi)
    heights = np.fft.irfft2((size * np.exp(1j * phase)).astype(np.complex64), s=(side, side)).astype(np.float32)
    heights -= heights.min()
    slope = np.hypot(*np.gradient(heights))
    return heights * (STEEP / np.quantile(slope.ravel()[::37], 0.94))


def write(heights: np.ndarray, path: Path) -> None:
    rows, columns = heights.shape
    options = ["TILED=YES", "COMPRESS=DEFLATE", "PREDICTOR=3"]
    data = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, 1, gdal.GDT_Float32, options)
    data.SetGeoTransform((500000, 1, 0, 5010000, 0, -1))
    system = osr.SpatialReference()
    system.ImportFromEPSG(25832)
    data.SetProjection(system.ExportToWkt())
    data.GetRasterBand(1).WriteArray(heights)


def write_project(folder: Path, side: int, rocks: int) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    write(mountains(side), folder / "dem.tif")
    project = folder / "run.toml"
    project.write_text(PROJECT.format(rocks=rocks))
    return project


def main() -> None:
    arguments = sys.argv[1:]

    def option(name: str, usual: int) -> int:
        if name not in arguments:
            return usual
        place = arguments.index(name)
        value = int(arguments[place + 1])
        del arguments[place : place + 2]
        return value

    side, rocks = option("--side", 10_000), option("--rocks", 1_000_000)
    if arguments[0] == "--write":
        write_project(Path(arguments[1]), side, rocks)
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        project = write_project(folder, side, rocks)
        used = measured([arguments[0], "run", str(project), "-q", "-o", str(folder / "out")])
        size = sum(file.stat().st_size for file in (folder / "out").rglob("*") if file.is_file())
        print(
            f"{side * side} cells, everything by default: {rocks} rocks, {len(os.sched_getaffinity(0))} threads, "
            f"{used.seconds:.1f} s, {rocks / used.seconds:.0f} rocks/s, {used.processor_s:.1f} s of processors, "
            f"{used.memory_mb:.0f} MB of memory, {size / 1e6:.0f} MB of files, hash {hash_of_results(folder / 'out')}"
        )


if __name__ == "__main__":
    main()
