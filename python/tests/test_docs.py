"""The documentation is true: the reference is not stale, and examples run."""

import os
from pathlib import Path
import re

import pytest

import reference_page
import talus

from conftest import SOURCE


def test_the_reference_is_not_stale():
    file = SOURCE / "docs/python-reference.md"
    text = reference_page.reference_page()
    if os.environ.get("TALUS_RENEW_REFERENCE"):
        file.write_text(text)
    assert file.read_text() == text, "renew it with TALUS_RENEW_REFERENCE=1"


def test_everything_public_has_a_docstring():
    for name in dir(talus):
        each = getattr(talus, name)
        if name.startswith("_") or not callable(each):
            continue
        assert each.__doc__, name
        for key, member in vars(each).items() if isinstance(each, type) else ():
            if not key.startswith("_") and (callable(member) or isinstance(member, (property, classmethod))):
                assert member.__doc__, f"{name}.{key}"


def test_the_page_runs(tmp_path, monkeypatch):
    """All code blocks but the last, in order; the last has a DEM of the reader's own."""
    page = (SOURCE / "docs/python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", page, re.S)
    monkeypatch.chdir(tmp_path)
    Path("slope.toml").write_text(talus.Project.starter().text.replace('name = "Type Three"', 'name = "Scree"')
                                  .replace('"Type Three"', '"Scree"'))
    names = {"x": [1, 2], "y": 0, "positions": [[1, 0, 5]], "velocities": [1, 0, 0]}
    for block in blocks[:-1]:
        exec(block, names)
    assert Path("out/summary.json").exists()
