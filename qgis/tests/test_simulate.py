"""Simulating: byte for byte what the command line computes, from layers of any kind."""

import filecmp
import json
import os
import shutil
import subprocess
import tomllib
import unittest
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsProcessingFeatureSourceDefinition,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)

from support import CLIFFS, PLUGINS, PROGRAM, VALLEY, Case, feature, vector

UTM = "EPSG:25832"


def files_below(folder):
    return sorted(str(file.relative_to(folder)) for file in Path(folder).rglob("*") if file.is_file())


class SameBytes(Case):
    def test_the_command_line_runs_the_project_again_to_the_same_bytes(self):
        cliffs = QgsVectorLayer(str(CLIFFS), "cliffs", "ogr")
        fences = vector(
            "LineString",
            UTM,
            ["name:string", "height_m:double", "capacity_kJ:double"],
            [("LINESTRING (652400 5234150, 652700 5234150)", ["Fence", 3.0, 500.0])],
            "fences",
        )
        found = self.simulate(RELEASE=cliffs, SOURCE_FIELD="name", BARRIERS=fences, MATERIAL_LIKE="talus_and_firm_soil")
        again = self.folder / "again"
        subprocess.run([PROGRAM, "run", found["PROJECT_FILE"], "-q", "-o", again], check=True)
        compare(self, found["RESULTS"], again)

    def test_outputs_are_those_that_were_chosen(self):
        line = vector("LineString", UTM, [], [("LINESTRING (652400 5234400, 652500 5234100)", [])], "fall line")
        found = self.simulate(
            RUNOUT=line, OUTPUT_REPORT=False, OUTPUT_MAPS=["energy_total"], OUTPUT_PERCENTILES="[90]"
        )
        project = tomllib.loads(self.project_text())
        self.assertEqual(
            project["output"],
            {
                "report": False,
                "maps": ["energy_total"],
                "percentiles": [90],
                "runout_along": [[652400, 5234400], [652500, 5234100]],
            },
        )
        written = files_below(found["RESULTS"])
        self.assertNotIn("report.html", written)
        self.assertIn("maps/energy_total_p90_kJ.tif", written)
        maps = [file for file in written if file.endswith(".tif")]
        self.assertFalse([file for file in maps if not file.startswith("maps/energy_total")])
        again = self.folder / "again"
        subprocess.run([PROGRAM, "run", found["PROJECT_FILE"], "-q", "-o", again], check=True)
        compare(self, found["RESULTS"], again)

    def test_qgis_process_computes_the_bytes_of_the_original_project(self):
        """The same cliffs and terrain, as the command line runs them from the files of the example."""
        example = self.folder / "example"
        example.mkdir()
        for file in (VALLEY, CLIFFS):
            shutil.copy(file, example)
        (example / "valley.toml").write_text(
            'name = "valley"\n[terrain]\nraster = "valley.tif"\n[[material]]\nname = "ground"\nlike = "talus_cover"\n'
            '[[seeder]]\ntype = "polygon"\npolygons = "cliffs.geojson"\nmin_slope_deg = 55\nrocks = 200\n'
            "height_above_m = 2\ndiameter_m = 0.8\n"
        )
        subprocess.run([PROGRAM, "run", example / "valley.toml", "-q"], check=True)
        values = self.values(MATERIAL_LIKE="talus_cover")
        process = "qgis_process.bin" if shutil.which("qgis_process.bin") else "qgis_process"
        environment = {**os.environ, "QGIS_PLUGINPATH": str(PLUGINS), "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        for command in (
            ["plugins", "enable", "talus_provider"],
            ["run", "talus:simulate", "--", *(f"{key}={value}" for key, value in values.items())],
        ):
            ended = subprocess.run([process, *command], env=environment, capture_output=True, text=True)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        self.assertIn("200 rocks in", ended.stdout)
        compare(self, self.folder / "project/valley", example / "valley", inputs_differ=True)


def compare(case, one, other, inputs_differ=False):
    """All files are the same, but for times, and for the names of the input files if those differ."""
    case.assertEqual(files_below(one), files_below(other))
    timed = {"summary.json", "report.html", "files.json"}
    for file in files_below(one):
        if file not in timed:
            case.assertTrue(filecmp.cmp(Path(one) / file, Path(other) / file, shallow=False), file)
    left = [{"timings", "inputs", "project", "fingerprint", "warnings"} if inputs_differ else {"timings"}] * 2
    summaries = [json.loads((Path(folder) / "summary.json").read_text()) for folder in (one, other)]
    one, other = (
        {key: value for key, value in summary.items() if key not in leave} for summary, leave in zip(summaries, left)
    )
    case.assertEqual(one, other)


class Layers(Case):
    """What layers become in the project file."""

    def project(self, **more):
        self.check(**more)
        return tomllib.loads(self.project_text())

    def test_edits_that_are_not_saved_are_written(self):
        layer = vector(
            "Polygon",
            UTM,
            [],
            [("POLYGON ((652250 5234230, 652450 5234230, 652450 5234400, 652250 5234230))", [])],
            "cliffs",
        )
        layer.startEditing()
        layer.addFeature(
            feature(layer, "POLYGON ((652550 5234230, 652750 5234230, 652750 5234400, 652550 5234230))", [])
        )
        self.project(RELEASE=layer)
        self.assertEqual(QgsVectorLayer(str(self.folder / "project/valley-release.gpkg"), "", "ogr").featureCount(), 2)
        self.assertTrue(any("edits that are not saved" in said for said in self.feedback.said))

    def test_selected_features_only(self):
        layer = QgsVectorLayer(str(CLIFFS), "cliffs", "ogr")
        QgsProject.instance().addMapLayer(layer)
        self.addCleanup(QgsProject.instance().removeAllMapLayers)
        layer.selectByExpression("name = 'East face'")
        self.project(RELEASE=QgsProcessingFeatureSourceDefinition(layer.id(), True))
        written = QgsVectorLayer(str(self.folder / "project/valley-release.gpkg"), "", "ogr")
        self.assertEqual(written.featureCount(), 1)

    def test_lines_and_points_release_rocks(self):
        crest = vector("LineString", UTM, [], [("LINESTRING (652300 5234300, 652400 5234300)", [])])
        self.assertEqual(self.project(RELEASE=crest, SEEDER_MIN_SLOPE_DEG=None)["seeder"][0]["type"], "line")
        points = vector("Point", UTM, ["mass_kg:double"], [("POINT (652300 5234300)", [700.0])])
        found = self.project(RELEASE=points, SEEDER_MIN_SLOPE_DEG=None, SEEDER_DIAMETER_M=None)
        self.assertEqual(found["seeder"][0]["table"], "valley-release.gpkg")

    def test_dem_without_coordinate_system_takes_that_of_the_setting(self):
        bare = QgsRasterLayer(str(VALLEY), "bare")
        bare.setCrs(QgsCoordinateReferenceSystem())
        self.project(DEM=bare, TERRAIN_CRS=UTM)
        self.assertTrue(any("EPSG:25832, 0 without data" in said for said in self.feedback.said))
        found = self.project(DEM=bare, TERRAIN_CRS="local", RELEASE=None)
        self.assertEqual(found["terrain"], {"raster": "valley-terrain.tif", "crs": "local"})

    def test_without_a_layer_rocks_start_from_steep_cells(self):
        self.assertEqual(self.project(RELEASE=None)["seeder"][0]["type"], "raster")

    def test_runout_is_counted_from_a_point_of_any_system(self):
        def point(text):
            return self.project(OUTPUT_RUNOUT_FROM=text)["output"]["runout_from"]

        self.assertEqual(point("652400,5234400 [EPSG:25832]"), [652400, 5234400])
        x, y = point("11.0125,47.2428 [EPSG:4326]")
        self.assertTrue(652000 < x < 653000 and 5234000 < y < 5235000, (x, y))

    def test_fields_give_the_values_of_each_barrier(self):
        fences = vector(
            "MultiLineString",
            "EPSG:4326",
            ["name:string", "height_m:double", "capacity_kJ:int"],
            [
                (
                    "MULTILINESTRING ((11.010 47.2428, 11.012 47.2428), (11.013 47.2428, 11.014 47.2428))",
                    ["Fence", 4.0, 500],
                ),
                ("MULTILINESTRING ((11.015 47.2428, 11.016 47.2428))", [None, None, None]),
            ],
        )
        found = self.project(BARRIERS=fences, BARRIER_HEIGHT_M=3)["barrier"]
        self.assertEqual(
            [(each["name"], each["height_m"], each.get("capacity_kJ")) for each in found],
            [("Fence", 4, 500), ("Fence 2", 4, 500), ("barrier 3", 3, None)],
        )
        for x, y in found[0]["line"]:
            self.assertTrue(652000 < x < 653000 and 5234000 < y < 5235000)

    def test_ground_from_the_library_and_from_fields(self):
        ground = vector(
            "Polygon",
            UTM,
            ["unit:string", "normal_restitution:double", "friction_angle_deg:string"],
            [
                (
                    "POLYGON ((652200 5234050, 652500 5234050, 652500 5234200, 652200 5234050))",
                    ["soft_soil", None, None],
                ),
                (
                    "POLYGON ((652500 5234050, 652700 5234050, 652700 5234200, 652500 5234050))",
                    ["Kalk", 0.5, '{ mean = 30, distribution = "normal", std_dev = 2 }'],
                ),
            ],
        )
        found = self.project(GROUND=ground, GROUND_FIELD="unit", MATERIAL_LIKE="soft_soil", MATERIAL_ROUGHNESS_DEG="0")
        self.assertEqual(
            found["material"],
            [
                {"name": "ground", "like": "soft_soil", "roughness_deg": 0},
                {"name": "soft_soil", "like": "soft_soil"},
                {
                    "name": "Kalk",
                    "normal_restitution": 0.5,
                    "friction_angle_deg": {"mean": 30, "distribution": "normal", "std_dev": 2},
                },
            ],
        )

    def test_forests_over_ground(self):
        """Forests are a layer of their own: materials and their polygons stay as they are."""
        ground = vector(
            "Polygon",
            UTM,
            ["unit:string"],
            [
                (
                    "POLYGON ((652300 5234050, 652500 5234050, 652500 5234250, 652300 5234250, 652300 5234050))",
                    ["soft_soil"],
                )
            ],
        )
        corners = "11.0125 {0}, 11.0155 {0}, 11.0155 {1}, 11.0125 {1}, 11.0125 {0}"
        forest = vector(
            "Polygon",
            "EPSG:4326",
            ["forest:string"],
            [
                (f"POLYGON (({corners.format(47.2428, 47.2433)}))", ["dense"]),
                (f"POLYGON (({corners.format(47.2433, 47.2438)}))", ["open"]),
            ],
        )
        found = self.project(GROUND=ground, GROUND_FIELD="unit", FORESTS=forest, MATERIAL_FOREST_HEIGHT_M=20)
        self.assertEqual([each["name"] for each in found["material"]], ["ground", "soft_soil"])
        of_file = {"polygons": "valley-forest.gpkg", "attribute": "forest", "height_m": 20}
        self.assertEqual(
            found["forest"],
            [
                {"name": "forest 20 dense", "values": ["forest 20 dense"], "density": "dense", **of_file},
                {"name": "forest 20 open", "values": ["forest 20 open"], "density": "open", **of_file},
            ],
        )
        self.assertFalse([said for said in self.feedback.said if "overlap" in said or "no effect" in said])


class Results(Case):
    def test_results_are_loaded_with_styles_in_a_group(self):
        import processing
        from qgis.core import QgsProcessingContext

        project = QgsProject.instance()
        self.addCleanup(project.clear)
        context = QgsProcessingContext()
        context.setProject(project)
        fences = vector("LineString", UTM, [], [("LINESTRING (652400 5234150, 652700 5234150)", [])])
        processing.runAndLoadResults(
            "talus:simulate", self.values(BARRIERS=fences, BARRIER_HEIGHT_M=3, LOAD=True), self.feedback, context
        )
        group = project.layerTreeRoot().children()[0]
        self.assertEqual(group.name(), "Talus: valley")
        self.assertEqual(
            [child.name() for child in group.children()],
            ["Barriers and collectors", "End points", "Releases", "Trajectories", "Maps"],
        )
        self.assertEqual(len(project.layerTreeRoot().children()), 1)
        maps = group.findGroup("Maps")
        self.assertEqual(maps.children()[1].name(), "Energy total p95 [kJ]")
        self.assertEqual([child.name() for child in maps.children() if child.isVisible()], [maps.children()[0].name()])
        self.assertEqual(maps.children()[0].layer().renderer().type(), "singlebandpseudocolor")
        paths = next(layer for layer in project.mapLayers().values() if layer.name() == "Trajectories")
        self.assertEqual(paths.renderer().type(), "graduatedSymbol")
        self.assertEqual(sum(range_.lowerValue() < float("inf") for range_ in paths.renderer().ranges()), 6)

    def test_classes_of_energies_are_those_of_the_maps(self):
        from talus_provider.styles import COLOURS, ENERGIES_KJ

        found = self.simulate()
        raster = QgsRasterLayer(str(Path(found["RESULTS"]) / "maps/energy_total_max_kJ.tif"), "energy")
        items = raster.renderer().shader().rasterShaderFunction().colorRampItemList()
        self.assertEqual([item.value for item in items], list(ENERGIES_KJ[1:]))
        self.assertEqual([item.color.name() for item in items], list(COLOURS))


class Design(Case):
    def test_stretches_are_the_rows_of_the_program(self):
        found = self.simulate(SEEDER_ROCKS=1000)
        fences = vector(
            "LineString",
            UTM,
            ["name:string"],
            [("LINESTRING (652400 5234150, 652560 5234140, 652700 5234150)", ["Fence"])],
        )
        layer = self.run_algorithm(
            "designalongline",
            RESULTS=found["RESULTS"],
            LINES=fences,
            DESIGN_SECTION_M=10,
            DESIGN_STANDARD="none",
            BARRIER_HEIGHT_M=4,
            BARRIER_CAPACITY_KJ=1000,
            OUTPUT="memory:",
        )["OUTPUT"]
        printed = subprocess.run(
            [
                PROGRAM,
                "line",
                found["RESULTS"],
                "--line",
                "652400,5234150 652560,5234140 652700,5234150",
                "--design",
                "section_m=10",
                "--design",
                'standard="none"',
                "--csv",
            ],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        header, _, *rows = [line.split(",") for line in printed.splitlines()]
        self.assertEqual([field.name() for field in layer.fields()], header)
        features = list(layer.getFeatures())
        self.assertEqual(len(features), len(rows))
        for one, row in zip(features, rows):
            for column, text in zip(header, row):
                if column == "line":
                    self.assertEqual(one[column], "Fence")
                elif text:
                    self.assertEqual(one[column], float(text), column)
                else:
                    self.assertEqual(one[column], None, column)
            self.assertAlmostEqual(one.geometry().length(), one["to_m"] - one["from_m"], places=6)
        self.assertTrue(any("Fence" in said for said in self.feedback.said))


class Provider(unittest.TestCase):
    def test_parameters_are_those_of_the_declaration(self):
        algorithm = QgsApplication.processingRegistry().createAlgorithmById("talus:simulate")
        declared = json.loads(subprocess.run([PROGRAM, "schema"], capture_output=True, check=True).stdout)["properties"]
        parameter = algorithm.parameterDefinition("ANALYSIS_MAX_TIMESTEP_S")
        self.assertEqual(parameter.description(), "Analysis: time step [s]")
        self.assertEqual(parameter.defaultValue(), declared["analysis"]["properties"]["max_timestep_s"]["default"])
        for table in ("analysis", "sampling"):
            for key in declared[table]["properties"]:
                self.assertIsNotNone(algorithm.parameterDefinition(f"{table}_{key}".upper()), key)

    def test_version_is_that_of_the_program(self):
        version = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(
            next(
                line.removeprefix("version=")
                for line in (PLUGINS / "talus_provider/metadata.txt").read_text().splitlines()
                if line.startswith("version=")
            ),
            version,
        )


if __name__ == "__main__":
    unittest.main()
