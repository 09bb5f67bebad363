"""The plugin finds its program, or says where it looked."""

import unittest
from pathlib import Path
from unittest import mock

from support import PROGRAM, Case, ProcessingConfig

from qgis.core import QgsApplication

from talus_provider import program


class Found(Case):
    def setUp(self):
        super().setUp()
        ProcessingConfig.setSettingValue("TALUS_PROGRAM", "")
        self.addCleanup(ProcessingConfig.setSettingValue, "TALUS_PROGRAM", str(PROGRAM))
        home = self.folder / "home"
        self.plugin = home / "profile/python/plugins/talus_provider"
        self.plugin.mkdir(parents=True)
        # No place outside of this folder has a program, also where Talus is installed.
        within = lambda path: str(path).startswith(str(self.folder)) and Path(path).is_file()  # noqa: E731
        for patch in (
            mock.patch.dict("os.environ", {"PATH": str(self.folder / "path"), "HOME": str(home)}),
            mock.patch.object(program, "PLUGIN", self.plugin),
            mock.patch.object(program, "is_program", within),
        ):
            patch.start()
            self.addCleanup(patch.stop)

    def put(self, place):
        path = self.folder / place / "talus"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("#!/bin/sh\n")
        path.chmod(0o755)
        return str(path)

    def test_the_setting_comes_first_then_the_path_then_other_places(self):
        for place in (
            "home/talus-9.9.9-linux-x86_64/bin",
            "home/talus/bin",
            "home/.local/bin",
            "home/profile/python/plugins/talus-9.9.9-linux-x86_64/bin",
            "home/profile/python/plugins/talus_provider/bin",
            "home/profile/python/plugins/talus_provider",
            "path",
        ):
            put = self.put(place)
            self.assertEqual(program.find(), put)
        chosen = self.put("chosen")
        ProcessingConfig.setSettingValue("TALUS_PROGRAM", chosen)
        self.assertEqual(program.find(), chosen)

    def test_the_places_of_packages(self):
        places = [str(place) for place in program.places()]
        self.assertIn("/usr/bin", places)
        self.assertIn("/usr/local/bin", places)

    def test_the_prefix_into_which_both_were_installed(self):
        with mock.patch.object(program, "PLUGIN", self.folder / "opt/share/qgis/python/plugins/talus_provider"):
            put = self.put("opt/bin")
            self.assertEqual(program.find(), put)

    def test_one_message_says_where_it_was_sought_and_what_helps(self):
        algorithm = QgsApplication.processingRegistry().createAlgorithmById("talus:simulate")
        can, why = algorithm.canExecute()
        self.assertFalse(can)
        self.assertTrue(why.startswith(f"The program talus was not found on the PATH ({self.folder / 'path'}), nor in "))
        for place in program.places():
            self.assertIn(str(place), why)
        self.assertTrue(
            why.endswith(
                f"Install it, with apt install ./talus_*.deb, or unpack its archive in {self.plugin.parent}; or give its"
                " place in Settings > Options > Processing > Providers > Talus."
            ),
            why,
        )
        self.assertIn(why, self.refusal(self.check))  # from a script, too

    def test_a_folder_is_no_program(self):
        with self.assertRaisesRegex(ValueError, "is not a program"):
            ProcessingConfig.setSettingValue("TALUS_PROGRAM", str(self.folder))


if __name__ == "__main__":
    unittest.main()
