"""What needs no QGIS: values as TOML, and the declaration of settings."""

import json
import math
import subprocess
import sys
import tomllib
import unittest

from support import PLUGINS, PROGRAM

sys.path.insert(0, str(PLUGINS))
from talus_provider import declaration, toml  # noqa: E402

SCHEMA = json.loads(subprocess.run([PROGRAM, "schema"], capture_output=True, check=True).stdout)


class Toml(unittest.TestCase):
    def read(self, value):
        return tomllib.loads(f"key = {toml.value(value)}")["key"]

    def test_values_are_read_back(self):
        for value in (
            1,
            -3.25,
            0.1 + 0.2,
            1e20,
            5e-324,
            math.inf,
            True,
            False,
            "",
            'a "b" \\ \n\t\x7f é',
            [[1.5, 2]],
            ["x"],
        ):
            self.assertEqual(self.read(value), value)

    def test_what_a_user_writes(self):
        for written, value in (
            ("0.35", 0.35),
            (" 12 ", 12),
            ("all", "all"),
            ("[50, 95]", [50, 95]),
            ("inf", math.inf),
            ('{ mean = 1, distribution = "normal" }', {"mean": 1, "distribution": "normal"}),
            ('say "x"', 'say "x"'),
            ("1_0", "1_0"),
        ):
            self.assertEqual(self.read(toml.Written(written)), value)

    def test_a_value_has_one_line(self):
        for written in ("1\n[output]", "1\r2"):
            with self.assertRaisesRegex(ValueError, "more than one line"):
                toml.Written(written)

    def test_a_number_that_is_none(self):
        with self.assertRaisesRegex(ValueError, "not a number"):
            toml.value(math.nan)

    def test_a_document(self):
        written = toml.document(
            "first",
            'a"b',
            [
                ("[terrain]", {"raster": "x.tif"}),
                ("[analysis]", {}),
                ("[[barrier]]", {"line": [[0.5, 1.0], [2.0, 3.0]]}),
            ],
        )
        self.assertEqual(
            tomllib.loads(written),
            {"name": 'a"b', "terrain": {"raster": "x.tif"}, "barrier": [{"line": [[0.5, 1.0], [2.0, 3.0]]}]},
        )
        self.assertTrue(written.startswith("# first\n"))


class Declaration(unittest.TestCase):
    def setting(self, table, key):
        return declaration.settings(SCHEMA, table)[key]

    def test_every_kind(self):
        for table, key, kind in (
            ("analysis", "gravity_m_s2", "number"),
            ("sampling", "seed", "integer"),
            ("output", "report", "boolean"),
            ("analysis", "model", "choice"),
            ("output", "maps", "choices"),
            ("sampling", "parameters", "file"),
            ("terrain", "crs", "text"),
            ("seeder", "diameter_m", "written"),
            ("output", "paths", "written"),
            ("output", "percentiles", "written"),
        ):
            self.assertEqual(self.setting(table, key).kind, kind, key)

    def test_unit_range_default_and_help_are_those_of_the_program(self):
        gravity, declared = (
            self.setting("analysis", "gravity_m_s2"),
            SCHEMA["properties"]["analysis"]["properties"]["gravity_m_s2"],
        )
        self.assertEqual(
            (gravity.default, gravity.minimum, gravity.maximum, gravity.unit),
            (declared["default"], declared["minimum"], declared["maximum"], declared["x-unit"]),
        )
        self.assertIn(declared["description"], gravity.help)
        self.assertEqual(gravity.title, "Gravity")
        rn = self.setting("material", "normal_restitution")
        self.assertEqual((rn.minimum, rn.maximum), (0, 1))

    def test_defaults_are_left_out_of_the_project_file(self):
        self.assertIsNone(self.setting("analysis", "gravity_m_s2").to_file(9.80665))
        self.assertIsNone(self.setting("design", "percentiles").to_file("[50, 95, 99]"))
        self.assertEqual(self.setting("analysis", "gravity_m_s2").to_file(9.81), 9.81)
        self.assertEqual(self.setting("output", "maps").to_file([]), [])


if __name__ == "__main__":
    unittest.main()
