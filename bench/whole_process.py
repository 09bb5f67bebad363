"""What a whole process takes, from start to exit, and the hash of the results of a run."""

import hashlib
import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Used:
    seconds: float
    processor_s: float
    memory_mb: float


def measured(command: list[str]) -> Used:
    with tempfile.TemporaryFile() as said:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        if status != 0:
            said.seek(0)
            sys.exit(f"{' '.join(command)}\n{said.read().decode(errors='replace')}")
    return Used(seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)


def hash_of_results(folder: Path) -> str:
    """Of all files of a run and the figures of its summary: nothing that depends on time or threads."""
    files = json.loads((folder / "files.json").read_text())["files"]
    sums = {name: entry for name, entry in files.items() if name not in ("summary.json", "report.html")}
    summary = json.loads((folder / "summary.json").read_text())
    figures = {key: summary[key] for key in ("rocks", "end_reasons", "events", "ways", "statistics", "histograms")}
    return hashlib.sha256(json.dumps([sums, figures], sort_keys=True).encode()).hexdigest()[:16]
