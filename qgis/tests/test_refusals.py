"""Bad input is refused in the user's words, and cancelling keeps what is done."""

import json
import shutil
import unittest
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsProcessingFeatureSourceDefinition,
    QgsProject,
    QgsRasterLayer,
    QgsRasterRange,
)

from support import PROGRAM, VALLEY, Case, Feedback, ProcessingConfig, vector

UTM = "EPSG:25832"
CREST = "LINESTRING (652300 5234300, 652400 5234300)"
TRIANGLE = "POLYGON ((652250 5234230, 652450 5234230, 652450 5234400, 652250 5234230))"


class Refusals(Case):
    def refused(self, **more):
        return self.refusal(self.check, **more)

    def dem(self, crs):
        layer = QgsRasterLayer(str(VALLEY), "hill")
        layer.setCrs(QgsCoordinateReferenceSystem(crs))
        return layer

    def test_dem_in_degrees(self):
        self.assertIn(
            'The DEM "hill" is in degrees (EPSG:4326). Talus computes in metres: reproject it first',
            self.refused(DEM=self.dem("EPSG:4326")),
        )

    def test_dem_in_feet(self):
        self.assertIn("feet", self.refused(DEM=self.dem("EPSG:2263")))

    def test_dem_without_coordinate_system(self):
        self.assertEqual(
            'The DEM "hill" has no coordinate system. Set it in the properties of the layer, or by "Terrain: coordinate'
            ' system" (TERRAIN_CRS): a code such as EPSG:25832, or local if the coordinates are metres without a map.',
            self.refused(DEM=self.dem(""), RELEASE=None),
        )

    def test_dem_with_an_unknown_coordinate_system(self):
        self.assertIn(
            '"Terrain: coordinate system" (TERRAIN_CRS) is "UTM 32", which QGIS does not know',
            self.refused(DEM=self.dem(""), TERRAIN_CRS="UTM 32", RELEASE=None),
        )

    def test_dem_with_hidden_values(self):
        layer = QgsRasterLayer(str(VALLEY), "hill")
        layer.dataProvider().setUserNoDataValue(1, [QgsRasterRange(-1, 0)])
        self.assertIn('The DEM "hill" hides values', self.refused(DEM=layer))

    def test_dem_with_two_coordinate_systems(self):
        self.assertIn(
            '"Terrain: coordinate system" (TERRAIN_CRS) has no effect. Leave it empty.',
            self.refused(TERRAIN_CRS="EPSG:25833"),
        )

    def test_local_dem_with_layers_that_are_somewhere(self):
        text = self.refused(DEM=self.dem(""), TERRAIN_CRS="local")
        self.assertIn('The layer "cliffs" (release) is in EPSG:4326, while the DEM has no coordinate system', text)
        self.assertIn('Give "Terrain: coordinate system" (TERRAIN_CRS) the coordinate system of the DEM', text)
        self.assertIn('give "Release areas, lines or points" (RELEASE) a layer without one', text)

    def test_layer_without_coordinate_system(self):
        layer = vector("Polygon", "", [], [(TRIANGLE, [])], "faces")
        layer.setCrs(QgsCoordinateReferenceSystem())
        self.assertIn(
            'The layer "faces" (release) has no coordinate system, while the DEM is in EPSG:25832',
            self.refused(RELEASE=layer),
        )

    def test_each_layer_without_coordinate_system_names_its_parameter(self):
        for name, title, kind, wkt in (
            ("RELEASE", "Release areas, lines or points", "Polygon", TRIANGLE),
            ("GROUND", "Ground polygons", "Polygon", TRIANGLE),
            ("FORESTS", "Forest polygons", "Polygon", TRIANGLE),
            ("BARRIERS", "Barriers", "LineString", CREST),
            ("COLLECTORS", "Collectors", "LineString", CREST),
            ("RUNOUT", "Output: line along which runout is counted", "LineString", CREST),
        ):
            with self.subTest(name):
                layer = vector(kind, "", [], [(wkt, [])], "bare")
                layer.setCrs(QgsCoordinateReferenceSystem())
                self.assertIn(
                    f'Set it in the properties of the layer, or give "{title}" ({name}) a file with a coordinate system',
                    self.refused(**{name: layer}),
                )

    def test_lines_of_a_design_without_coordinate_system(self):
        found = self.simulate()
        layer = vector("LineString", "", [], [(CREST, [])], "bare")
        layer.setCrs(QgsCoordinateReferenceSystem())
        self.assertIn(
            'Give "Lines" (LINES) a layer with a coordinate system.',
            self.refusal(
                lambda: self.run_algorithm("designalongline", RESULTS=found["RESULTS"], LINES=layer, OUTPUT="memory:")
            ),
        )

    def test_empty_layer(self):
        self.assertIn(
            'The layer "faces" (release) has no features', self.refused(RELEASE=vector("Polygon", UTM, [], [], "faces"))
        )

    def test_layer_elsewhere(self):
        layer = vector("Polygon", "EPSG:25833", [], [(TRIANGLE, [])], "faces")
        self.assertIn('The layer "faces" (release) lies elsewhere than the DEM', self.refused(RELEASE=layer))

    def test_all_problems_of_layers_at_once(self):
        text = self.refused(DEM=self.dem("EPSG:4326"), BARRIERS=vector("LineString", UTM, [], [], "fences"))
        self.assertIn("is in degrees", text)
        self.assertIn('"fences" (barriers) has no features', text)

    def test_runout_along_two_lines(self):
        one, two = (f"LINESTRING ({x} 5234400, {x} 5234100)" for x in (652400, 652500))
        lines = vector("LineString", UTM, [], [(one, []), (two, [])], "paths")
        self.assertIn(
            'The layer "paths" (runout) has 2 lines, and runout is counted along one', self.refused(RUNOUT=lines)
        )

    def test_runout_from_a_point_and_along_a_line(self):
        line = vector("LineString", UTM, [], [("LINESTRING (652400 5234400, 652500 5234100)", [])], "path")
        self.assertIn("runout_along", self.refused(RUNOUT=line, OUTPUT_RUNOUT_FROM="652400,5234400 [EPSG:25832]"))

    def test_nothing_to_release(self):
        self.assertIn("Choose a layer from which rocks start", self.refused(RELEASE=None, SEEDER_MIN_SLOPE_DEG=None))

    def test_problems_of_the_project_are_those_of_the_program(self):
        text = self.refused(
            SEEDER_DIAMETER_M='{ mean = 0.8, distribution = "nromal" }', MATERIAL_NORMAL_RESTITUTION="1.3"
        )
        self.assertIn("valley.toml:", text)
        self.assertIn("normal_restitution", text)
        self.assertIn("nromal", text)

    def test_a_value_of_two_lines(self):
        self.assertIn("more than one line", self.refused(SEEDER_DIAMETER_M="0.8\n[output]"))

    def test_a_name_that_leaves_the_folder(self):
        self.assertIn("is no name of a project", self.refused(NAME="../valley"))

    def test_ground_that_is_no_material(self):
        ground = vector("Polygon", UTM, ["unit:string"], [(TRIANGLE, ["Kalk"]), (TRIANGLE, [None])], "geology")
        text = self.refused(GROUND=ground, GROUND_FIELD="unit")
        self.assertIn('"Kalk" in "unit" of the layer "geology" is no material', text)
        self.assertIn('feature 2 of the layer "geology" has no value in "unit"', text)

    def test_a_field_that_names_a_file(self):
        for text in ('{ distribution = "empirical", file = "/etc/passwd" }', '{ "fil\\u0065" = "x" }'):
            ground = vector("Polygon", UTM, ["unit:string", "normal_restitution:string"], [(TRIANGLE, ["Kalk", text])])
            self.assertIn("no distribution that a layer may give", self.refused(GROUND=ground, GROUND_FIELD="unit"))

    def test_no_selected_features(self):
        layer = vector("Polygon", UTM, [], [(TRIANGLE, [])], "faces")
        QgsProject.instance().addMapLayer(layer)
        self.addCleanup(QgsProject.instance().removeAllMapLayers)
        self.assertIn(
            '"faces" (release) has no selected features',
            self.refused(RELEASE=QgsProcessingFeatureSourceDefinition(layer.id(), True)),
        )

    def test_forest_without_density(self):
        forest = vector("Polygon", UTM, [], [(TRIANGLE, [])], "woods")
        self.assertIn('"woods" (forests) has no density', self.refused(FORESTS=forest))

    def test_a_file_that_the_plugin_has_not_written_stays(self):
        folder = self.folder / "project"
        folder.mkdir()
        (folder / "valley.toml").write_text("# mine\n")
        self.assertIn("exists and was not written by this plugin", self.refused())
        self.assertEqual((folder / "valley.toml").read_text(), "# mine\n")

    def test_a_layer_that_would_be_overwritten(self):
        self.check()
        self.assertIn("would be overwritten", self.refused(DEM=str(self.folder / "project/valley-terrain.tif")))

    def test_without_the_program(self):
        gone = self.folder / "talus"
        shutil.copy(PROGRAM, gone)
        ProcessingConfig.setSettingValue("TALUS_PROGRAM", str(gone))
        self.addCleanup(ProcessingConfig.setSettingValue, "TALUS_PROGRAM", str(PROGRAM))
        gone.unlink()
        algorithm = QgsApplication.processingRegistry().createAlgorithmById("talus:simulate")
        can, why = algorithm.canExecute()
        self.assertFalse(can)
        self.assertIn(str(gone), why)

    def test_a_setting_that_is_no_program(self):
        with self.assertRaisesRegex(ValueError, "is not a program"):
            ProcessingConfig.setSettingValue("TALUS_PROGRAM", str(VALLEY))

    def test_a_folder_without_results(self):
        self.assertIn(
            "has no results of Talus", self.refusal(lambda: self.run_algorithm("loadresults", RESULTS=str(self.folder)))
        )

    def test_damaged_results(self):
        (self.folder / "summary.json").write_text('{"name": "x"}')
        (self.folder / "results.gpkg").write_bytes(b"no database, but more bytes than the header of one has" * 20)
        load = lambda: self.run_algorithm("loadresults", RESULTS=str(self.folder))  # noqa: E731
        self.assertIn("results.gpkg is damaged", self.refusal(load))
        (self.folder / "summary.json").write_text("[]")
        self.assertIn("is no summary of a run", self.refusal(load))

    def test_ground_that_crosses_itself(self):
        bow = "POLYGON ((652200 5234050, 652500 5234200, 652500 5234050, 652200 5234200, 652200 5234050))"
        ground = vector("Polygon", UTM, ["unit:string"], [(bow, ["soft_soil"])], "geology")
        forest = vector("Polygon", UTM, ["forest:string"], [(TRIANGLE, ["open"])], "woods")
        for layers in ({}, {"FORESTS": forest, "MATERIAL_FOREST_HEIGHT_M": 20}):
            text = self.refused(GROUND=ground, GROUND_FIELD="unit", **layers)
            self.assertRegex(text, "not a valid polygon|laid over")

    def test_lines_in_another_world_than_the_results(self):
        found = self.simulate()
        lines = vector("LineString", UTM, [], [("LINESTRING (0 0, 1 1)", [])], "fences")
        self.assertIn(
            "does not touch the terrain",
            self.refusal(
                lambda: self.run_algorithm("designalongline", RESULTS=found["RESULTS"], LINES=lines, OUTPUT="memory:")
            ),
        )


class Cancel(Case):
    def test_cancel_keeps_what_is_done(self):
        self.feedback = Feedback(cancel=True)
        # Little to write, because results that take more than a second are left to a run that continues this one.
        little = {f"OUTPUT_{table}": "none" for table in ("TRAJECTORIES_MB", "ENDPOINTS", "PATHS", "GEOPACKAGE")}
        self.simulate(SEEDER_ROCKS=10_000_000, OUTPUT_MAPS=["reach_share"], OUTPUT_REPORT=False, **little)
        summary = json.loads((self.folder / "project/valley/summary.json").read_text())
        self.assertTrue(summary["interrupted"])
        self.assertGreater(summary["rocks"]["done"], 0)
        self.assertLess(summary["rocks"]["done"], 10_000_000)
        self.assertEqual(self.feedback.steps, sorted(self.feedback.steps))
        self.feedback = Feedback()
        layers = self.run_algorithm("loadresults", RESULTS=str(self.folder / "project/valley"))["LAYERS"]
        self.assertTrue(any(Path(layer).name == "reach_share.tif" for layer in layers))
        self.assertTrue(any("interrupted" in said for said in self.feedback.said))

    def test_a_cancelled_run_is_continued_to_the_same_bytes(self):
        self.feedback = Feedback(cancel=True)
        layers = {"SEEDER_ROCKS": 3000, "OUTPUT_MAPS": ["reach_share"]}
        cancelled = self.simulate(**layers)
        stopped = Path(cancelled["RESULTS"])
        self.feedback = Feedback()
        self.run_algorithm("runproject", PROJECT_FILE=cancelled["PROJECT_FILE"], LOAD=False)
        whole = Path(self.simulate(OUTPUT=str(self.folder / "whole"), **layers)["RESULTS"])
        for file in ("endpoints.csv", "paths.csv", "maps/reach_share.tif", "results.gpkg"):
            self.assertEqual((stopped / file).read_bytes(), (whole / file).read_bytes(), file)
        for file in ("valley.toml", "valley-release.gpkg", "valley-terrain.tif"):
            self.assertEqual(
                (self.folder / "project" / file).read_bytes(), (self.folder / "whole" / file).read_bytes(), file
            )


if __name__ == "__main__":
    unittest.main()
