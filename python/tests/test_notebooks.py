"""The notebooks run, and keep what they put out: texts as they are, and a picture where a cell draws one."""

import base64
import json
import os
import re

import pytest

from conftest import SOURCE

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")

FOLDER = SOURCE / "examples/notebooks"
NAMES = sorted(file.stem for file in FOLDER.glob("*.ipynb"))


def test_there_are_notebooks():
    assert len(NAMES) == 5


@pytest.mark.parametrize("name", NAMES)
def test_a_notebook_runs_and_is_not_stale(name):
    file = FOLDER / f"{name}.ipynb"
    kept, run = (nbformat.read(file, as_version=4) for _ in range(2))
    nbclient.NotebookClient(run, timeout=240, resources={"metadata": {"path": FOLDER}}).execute()
    if os.environ.get("TALUS_RENEW_REFERENCE"):
        write(run, file)
        kept = nbformat.read(file, as_version=4)
    for old, new in zip(kept.cells, run.cells):
        assert texts_of(old) == texts_of(new), f"{name}: renew it with TALUS_RENEW_REFERENCE=1"
        assert [is_png(each) for each in pictures_of(old)] == [True] * len(pictures_of(new)), (
            f"{name} lacks a picture: renew it with TALUS_RENEW_REFERENCE=1")
    assert file.stat().st_size < 300_000


def texts_of(cell):
    """The text that a cell has put out. Pictures and HTML change with the versions of what draws them."""
    outputs = [out for out in cell.get("outputs", []) if "image/png" not in out.get("data", {})]
    return "".join(out.get("text", "") or out.get("data", {}).get("text/plain", "") for out in outputs)


def pictures_of(cell):
    """In base64: figures, and those within the HTML of results."""
    found = []
    for data in (out.get("data", {}) for out in cell.get("outputs", [])):
        found += [data["image/png"]] if "image/png" in data else []
        found += re.findall('src="data:image/png;base64,([^"]*)"', data.get("text/html", ""))
    return found


def is_png(picture):
    return base64.b64decode(picture).startswith(b"\x89PNG")


def write(notebook, file):
    """Without times, warnings of the kernel and the division of streams, which change from run to run."""
    notebook.metadata = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                         "language_info": {"name": "python"}}
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        streams = [out for out in cell.get("outputs", []) if out.get("name") == "stdout"]
        for out in streams[1:]:
            streams[0]["text"] += out["text"]
        if cell.cell_type == "code":
            cell.outputs = [out for out in cell.outputs if out.output_type != "stream" or out is streams[0]]
    file.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")
