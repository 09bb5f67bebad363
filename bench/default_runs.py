#!/usr/bin/env python3
"""A long run with all default outputs, as a whole process: rocks per second, processor time, memory and bytes.

    bench/default_runs.py PROGRAM [--rocks N]

Tutorial 1 as a mesh, with a million rocks: on one thread, on all, and on all without files.
"""

import os
import sys
import tempfile
from pathlib import Path

from whole_process import hash_of_results, measured

project = Path(__file__).resolve().parent.parent / "examples/tutorial-1/tutorial-1-3d.toml"
OFF = {"endpoints": "none", "paths": "none", "trajectories": "none", "geopackage": "none", "report": "false", "maps": "false"}


def run(program: str, rocks: int, threads: int, off: dict[str, str]) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "out"
        command = [program, "run", str(project), "-q", "--rocks", str(rocks), "--threads", str(threads), "-o", str(folder)]
        for key, value in off.items():
            command += ["--set", f"output.{key}={value}"]
        used = measured(command)
        size = sum(file.stat().st_size for file in folder.rglob("*") if file.is_file())
        print(
            f"{'tutorial 1 without files' if off else 'tutorial 1, everything by default'}: {rocks} rocks, {threads} threads, "
            f"{used.seconds:.1f} s, {rocks / used.seconds:.0f} rocks/s, {used.processor_s:.1f} s of processors, "
            f"{used.memory_mb:.0f} MB of memory, {size / 1e6:.0f} MB of files, hash {hash_of_results(folder)}"
        )


def main() -> None:
    arguments = sys.argv[1:]
    rocks = int(arguments.pop(arguments.index("--rocks") + 1)) if "--rocks" in arguments else 1_000_000
    program = next(argument for argument in arguments if argument != "--rocks")
    cores = len(os.sched_getaffinity(0))
    for threads in sorted({1, cores}):
        run(program, rocks, threads, {})
    run(program, rocks, cores, OFF)


if __name__ == "__main__":
    main()
