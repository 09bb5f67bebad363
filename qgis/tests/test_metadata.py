"""metadata.txt has what QGIS and its repository of plugins ask for, as far as the project has it."""

import configparser
import re
import unittest

from support import PLUGINS, SOURCES

PLUGIN = PLUGINS / "talus_provider"
# What the repository of plugins demands, but for the addresses that the project does not have yet: tracker, repository
# and homepage.
DEMANDED = ("name", "qgisMinimumVersion", "description", "about", "version", "author", "email")
ADVISED = ("changelog", "tags", "category", "icon", "hasProcessingProvider", "experimental", "deprecated")


class Metadata(unittest.TestCase):
    def setUp(self):
        parser = configparser.ConfigParser(interpolation=None)
        parser.optionxform = str
        parser.read(PLUGIN / "metadata.txt", encoding="utf-8")
        self.metadata = parser["general"]

    def test_every_entry_is_there(self):
        for key in DEMANDED + ADVISED:
            self.assertTrue(self.metadata.get(key, "").strip(), key)
        self.assertTrue((PLUGIN / self.metadata["icon"]).exists())
        self.assertNotIn("plugin", self.metadata["name"].lower())

    def test_the_changelog_begins_with_this_version(self):
        first = self.metadata["changelog"].strip().splitlines()[0]
        self.assertTrue(first.startswith(self.metadata["version"] + ":"), first)

    def test_addresses_are_links(self):
        for key in ("homepage", "tracker", "repository"):
            if key in self.metadata:
                self.assertTrue(re.match(r"https?://[^ ]+$", self.metadata[key]), key)

    def test_the_licence_is_that_of_the_project(self):
        self.assertEqual((PLUGIN / "LICENSE").read_bytes(), (SOURCES / "LICENSE").read_bytes())


if __name__ == "__main__":
    unittest.main()
