#!/usr/bin/env python3
"""Counts the instructions that the program takes for a rock, and compares them with the record.

    bench/instructions.py PROGRAM COMPILER [--renew]

The record is bench/results/instructions.csv: one row for each case, counted by callgrind in the program of a release
build with COMPILER (its name and version). Unlike time, the counts hardly differ between runs and machines. A count of more
than 3 % above the record fails; so does one of more than 3 % below it, for the record would hide a later loss. With
--renew, the record is written anew: in the commit that changes the counts, with the reason in its body.

Exit codes: 0 as recorded, 1 other counts, 77 not comparable here (no callgrind, another compiler or processor).
"""

import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

here = Path(__file__).resolve().parent
record = here / "results" / "instructions.csv"
tolerance = 0.03
not_comparable = 77

NO_FILES = ["endpoints=none", "paths=none", "trajectories=none", "geopackage=none", "report=false"]
SIMULATED = "talus::run_campaign*"  # the function within which instructions count
RUN = "talus::project::run_into*"


@dataclass
class Case:
    """A run of an example: `within` is the function that counts, with all that it calls; empty: the whole process."""

    name: str
    project: str
    rocks: int
    within: str
    output: list[str]
    analysis: list[str]


KERNEL = [*NO_FILES, "maps=false"]
cases = [
    Case("section", "tutorial-1/tutorial-1-2d", 1000, SIMULATED, KERNEL, []),
    Case("mesh", "tutorial-1/tutorial-1-3d", 1000, SIMULATED, KERNEL, []),
    Case("raster", "first-gis-run/first-gis-run", 400, SIMULATED, KERNEL, []),
    Case("sphere", "first-gis-run/first-gis-run", 100, SIMULATED, KERNEL, ["model=rigid_sphere"]),
    Case("shape", "blocks/blocks", 20, SIMULATED, KERNEL, []),
    Case("maps", "first-gis-run/first-gis-run", 300, RUN, NO_FILES, []),
    Case("default", "first-gis-run/first-gis-run", 300, "", [], []),
]


def instructions(program: str, case: Case) -> float:
    """For a rock."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
        if case.within:
            command += ["--collect-atstart=no", f"--toggle-collect={case.within}"]
        command += [program, "run", str(here.parent / "examples" / f"{case.project}.toml"), "-o", f"{folder}/out"]
        command += ["--rocks", str(case.rocks), "--threads", "1", "--checkpoint-every", "0"]
        for table, settings in (("output", case.output), ("analysis", case.analysis)):
            for setting in settings:
                command += ["--set", f"{table}.{setting}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        counted = re.search(r"Collected : (\d+)", done.stderr)
        if done.returncode != 0 or counted is None or counted[1] == "0":
            sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
        return int(counted[1]) / case.rocks


def why_not_comparable(compiler: str) -> str | None:
    if shutil.which("valgrind") is None:
        return "valgrind is not installed"
    flags = Path("/proc/cpuinfo").read_text() if os.path.exists("/proc/cpuinfo") else ""
    if not re.search(r"^flags\s*:.*\bavx2\b", flags, re.M):
        return "libraries choose other code on a processor without AVX2"
    with record.open(newline="") as file:
        recorded = next(csv.DictReader(file))["compiler"]
    return None if recorded == compiler else f"the record is of {recorded}, this is {compiler}"


def main() -> int:
    program, compiler = sys.argv[1:3]
    is_renewal = "--renew" in sys.argv[3:]
    if not is_renewal and (why := why_not_comparable(compiler)):
        print(f"not comparable: {why}")
        return not_comparable
    counts = {case.name: round(instructions(program, case)) for case in cases}
    if is_renewal:
        with record.open("w", newline="") as file:
            rows = csv.writer(file, lineterminator="\n")
            rows.writerow(["case", "instructions_per_rock", "compiler"])
            rows.writerows([name, count, compiler] for name, count in counts.items())
        return 0
    with record.open(newline="") as file:
        recorded = {row["case"]: int(row["instructions_per_rock"]) for row in csv.DictReader(file)}
    code = 0
    for name, count in counts.items():
        change = count / recorded[name] - 1 if name in recorded else float("inf")
        verdict = "" if abs(change) <= tolerance else "  differs: renew the record in this commit, and say why"
        code |= bool(verdict)
        print(f"{name}: {count} instructions for a rock, {100 * change:+.1f} %{verdict}")
    return code


if __name__ == "__main__":
    sys.exit(main())
