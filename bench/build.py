#!/usr/bin/env python3
"""Runs a build and says what it cost, in processor-minutes.

    bench/build.py NAME COMMAND...

NAME is the name of the build in bench/results/build.csv. The cost of a whole build (an empty build folder, nothing from a
compiler cache) is compared with the last row of that name there, and is a warning if it is 10 % more. Because machines
differ, costs are compared as multiples of a reference: that of compiling build_reference.cpp on the same machine. The
exit code is that of COMMAND, whatever it cost.
"""

import csv
import resource
import subprocess
import sys
from pathlib import Path

here = Path(__file__).resolve().parent
rows = here / "results" / "build.csv"
growth = 1.1  # that is a warning


def children_s() -> float:
    """Processor time of all processes that this one has started and that have ended [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def cost_of(command: list[str], **options) -> tuple[float, int]:
    before = children_s()
    code = subprocess.run(command, check=False, **options).returncode
    return children_s() - before, code


def cache_hits() -> int:
    """Files that the compiler cache has given so far; 0 without one."""
    try:
        found = subprocess.run(["ccache", "--print-stats"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return 0
    counts = dict(line.split("\t")[:2] for line in found.stdout.splitlines() if "\t" in line)
    return sum(int(counts.get(key, 0)) for key in ("direct_cache_hit", "preprocessed_cache_hit"))


def reference_s() -> float | None:
    """None: the reference does not compile here."""
    command = ["c++", "-std=c++20", "-O2", "-I/usr/include/eigen3", "-c", "-o", "/dev/null"]
    cost, code = cost_of([*command, str(here / "build_reference.cpp")])
    return cost if code == 0 else None


def last_row(name: str) -> dict[str, str] | None:
    if not rows.exists():
        return None
    with rows.open(newline="") as file:
        found = [row for row in csv.DictReader(file) if row["build"] == name]
    return found[-1] if found else None


def main() -> int:
    name, command = sys.argv[1], sys.argv[2:]
    is_first = not any(Path("build").glob("**/*.o"))
    hits = cache_hits()
    cost, code = cost_of(command)
    if code != 0 or not is_first or cache_hits() != hits:
        return code
    reference = reference_s()
    if reference is None:
        print(f"Built in {cost / 60:.1f} processor-minutes.")
        return 0
    multiple = cost / reference
    print(f"Built in {cost / 60:.1f} processor-minutes, {multiple:.0f} times the reference of {reference:.1f} s.")
    last = last_row(name)
    if last is not None and multiple > growth * float(last["multiple"]):
        print(f"warning: this build cost {last['multiple']} times the reference on {last['date']}; "
              f"it has grown by {100 * (multiple / float(last['multiple']) - 1):.0f} % (bench/results/build.csv)")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:  # the build says so
        sys.exit(130)
