"""The commands of docs/qgis.md as a new user runs them, and relative folders."""

import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from support import CLIFFS, PLUGINS, PROGRAM, SOURCES, VALLEY, Case

PAGE = SOURCES / "docs/qgis.md"


class CommandLine(Case):
    def test_commands_of_the_page_run_as_printed(self):
        home, work = self.folder / "home", self.folder / "work"
        work.mkdir()
        plugins = home / ".local/share/QGIS/QGIS3/profiles/default/python/plugins"
        shutil.copytree(PLUGINS / "talus_provider", plugins / "talus_provider")
        for file in (VALLEY, CLIFFS):
            shutil.copy(file, work)
        section = PAGE.read_text(encoding="utf-8").split("## Without a window")[1]
        (commands,) = re.findall(r"```sh\n(.*?)```", section, re.DOTALL)
        environment = {"HOME": str(home), "PATH": f"{PROGRAM.parent}:/usr/bin:/bin", "LC_ALL": "C.UTF-8"}
        ended = subprocess.run(
            ["sh", "-e", "-c", commands], cwd=work, env=environment, capture_output=True, text=True
        )
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertIn("rocks in", ended.stdout)
        self.assertIn("SEEDER_ROCKS_PER_CELL", ended.stdout)
        self.assertTrue((work / "project/rockfall/summary.json").exists())

    def test_relative_folders(self):
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        found = self.simulate(OUTPUT="project", LOAD=True)
        self.assertEqual(Path(found["RESULTS"]), self.folder / "project/valley")
        self.assertEqual(Path(found["OUTPUT"]), self.folder / "project")
        layers = self.run_algorithm("loadresults", RESULTS="project/valley")["LAYERS"]
        self.assertTrue(layers and all(Path(layer).is_absolute() for layer in layers))
        again = self.run_algorithm("runproject", PROJECT_FILE="project/valley.toml", LOAD=True)
        self.assertEqual(Path(again["RESULTS"]), self.folder / "project/valley")
        checked = self.values(OUTPUT="project")
        del checked["LOAD"]
        self.assertEqual(Path(self.run_algorithm("check", **checked)["OUTPUT"]), self.folder / "project")


if __name__ == "__main__":
    unittest.main()
