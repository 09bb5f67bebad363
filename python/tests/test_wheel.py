"""What pyproject.toml names exists; building the wheel itself takes as long as building the engine."""

import re
import tomllib

import talus

from conftest import SOURCE

WHEEL = tomllib.loads((SOURCE / "pyproject.toml").read_text())
CMAKE = "\n".join(file.read_text() for file in [
    SOURCE / "CMakeLists.txt", SOURCE / "python/CMakeLists.txt", *sorted((SOURCE / "cmake").glob("*.cmake"))])


def test_its_version_is_that_of_the_program():
    version = WHEEL["tool"]["scikit-build"]["metadata"]["version"]
    assert re.search(version["regex"], (SOURCE / version["input"]).read_text())["value"] == talus.__version__


def test_what_it_builds_with_cmake_is_declared():
    settings = WHEEL["tool"]["scikit-build"]
    for target in settings["build"]["targets"]:
        assert f"pybind11_add_module({target} " in CMAKE
    for component in settings["install"]["components"]:
        assert f"COMPONENT {component})" in CMAKE
    for name in settings["cmake"]["define"]:
        assert re.search(rf"(option\({name} |set\({name} )", CMAKE), name


def test_its_readme_exists():
    assert (SOURCE / WHEEL["project"]["readme"]).is_file()
