// Projects whose terrain is a survey or closed polylines: the rules of their keys, and whole runs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/input_folder.hpp"
#include "support/places.hpp"
#include "support/projects.hpp"
#include "talus/campaign/simulate.hpp"

#ifdef TALUS_HAS_GDAL
#include "support/rasters.hpp"
#include "support/vectors.hpp"
#endif

namespace talus::project {
namespace {

using ::testing::HasSubstr;

const std::string tables_after_terrain = R"(
[[material]]
name = "Rock"
[[seeder]]
name = "Crest"
position = [2, 10]
height_above_m = 5
rocks = 10
mass_kg = 1000
horizontal_velocity_m_s = 3
)";

struct BadSurvey {
  const char* name;
  std::string terrain, message;
};
void PrintTo(const BadSurvey& bad, std::ostream* out) { *out << bad.name; }

class BadSurveyTest : public ::testing::TestWithParam<BadSurvey> {};

TEST_P(BadSurveyTest, IsRefusedWithThisText) {
  EXPECT_EQ(testing_tools::refusal_of_reading("[terrain]\n" + GetParam().terrain + tables_after_terrain),
            GetParam().message);
}

const std::vector<BadSurvey> bad_terrains{
    {"SurveyAndRaster", "points = \"p.csv\"\nraster = \"dem.tif\"",
     "slope.toml:2: [terrain]: raster and points are given together (they exclude each other)"},
    {"SurveyAndPolylines", "lines = \"l.gpkg\"\npolylines = [[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0]]]",
     "slope.toml:3: [terrain]: lines and polylines are given together (they exclude each other)"},
    {"ClassesOfText", "points = \"p.csv\"\npoint_classes = [2]",
     "slope.toml:3: [terrain]: point_classes is given for p.csv (only LAS points have classes). Leave it out"},
    {"ClassOutOfRange", "points = \"p.las\"\npoint_classes = [2, 300]",
     "slope.toml:3: [terrain]: point_classes[1] is 300 (expected 0 to 255)"},
    {"LayerWithoutPoints", "lines = \"l.gpkg\"\npoints_layer = \"spots\"",
     "slope.toml:3: [terrain]: points_layer is given without points (it would have no effect)"},
    {"LayerWithoutLines", "points = \"p.csv\"\nlines_layer = \"contours\"",
     "slope.toml:3: [terrain]: lines_layer is given without lines (it would have no effect)"},
    {"AttributeOfAMesh", "mesh = \"m.obj\"\nelevation_attribute = \"z\"",
     "slope.toml:3: [terrain]: elevation_attribute is given without points or lines (it would have no effect)"},
    {"BoundaryOfARaster", "raster = \"dem.tif\"\nboundary = \"area.gpkg\"\nmax_edge_m = 5",
     "slope.toml:3: [terrain]: boundary is given without points or lines (it would have no effect)\n"
     "slope.toml:4: [terrain]: max_edge_m is given without points or lines (it would have no effect)"},
    {"LayerWithoutBoundary", "points = \"p.csv\"\nboundary_layer = \"area\"",
     "slope.toml:3: [terrain]: boundary_layer is given without a boundary (it would have no effect)"},
    {"SpikesOfLines", "lines = \"l.gpkg\"\nremove_spikes_m = 5",
     "slope.toml:3: [terrain]: remove_spikes_m is given without points (it would have no effect)"},
    {"ZeroSpikes", "points = \"p.csv\"\nremove_spikes_m = 0",
     "slope.toml:3: [terrain]: remove_spikes_m is 0 (expected more than 0, up to 1e9)"},
    {"NegativeLength", "points = \"p.csv\"\nmax_edge_m = -5",
     "slope.toml:3: [terrain]: max_edge_m is -5 (expected more than 0, up to 1e9)"},
    {"MergedSurvey", "points = \"p.csv\"\nmerge_tolerance_m = 0.5",
     "slope.toml:3: [terrain]: merge_tolerance_m is given without polylines or polygons or mesh (it would have no "
     "effect)"},
    {"LayerOfPolylines", "points = \"p.csv\"\npolygons_layer = \"faces\"",
     "slope.toml:3: [terrain]: polygons_layer is given without polygons (it would have no effect)"},
    {"RotatedSurvey", "points = \"p.csv\"\nrotate_deg = 30",
     "slope.toml:3: [terrain]: rotate_deg is given with points (a survey has a fixed position). Leave it out"},
    {"CrsOfASection", "section = [[0, 0], [10, -10]]\nwidth_m = 5\ncrs = \"EPSG:31287\"",
     "slope.toml:4: [terrain]: crs is given for a section (a section has no position on a map). Leave it out"},
    {"NoPolylines", "polylines = []", "slope.toml:2: [terrain]: polylines is empty (a terrain has at least one)"},
    {"OpenPolyline",
     "polylines = [[[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 0, 0]], [[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0]]]",
     "slope.toml:2: [terrain]: polylines[1] is not closed (its ends are 9 m apart). Repeat its first vertex at its "
     "end"},
    {"ShortPolyline", "polylines = [[[0, 0, 0], [9, 0, 0], [0, 0, 0]]]",
     "slope.toml:2: [terrain]: polylines[0] has 3 vertices (a closed polyline has four or more, the last equal to the "
     "first)"},
    {"PolylineOnPlan", "polylines = [[[0, 0], [9, 0], [9, 9], [0, 0]]]",
     "slope.toml:2: [terrain]: polylines[0][0] is [0, 0] (expected three numbers [..., ..., ...])\n"
     "slope.toml:2: [terrain]: polylines[0][1] is [9, 0] (expected three numbers [..., ..., ...])\n"
     "slope.toml:2: [terrain]: polylines[0][2] is [9, 9] (expected three numbers [..., ..., ...])\n"
     "slope.toml:2: [terrain]: polylines[0][3] is [0, 0] (expected three numbers [..., ..., ...])"},
    {"GroundByTriangles", "points = \"p.csv\"\n[ground]\ntriangles = [0]",
     "slope.toml:4: [ground]: triangles is given for a survey (Talus generates its triangles). Use raster and classes, "
     "or polygons"},
};

INSTANTIATE_TEST_SUITE_P(All, BadSurveyTest, ::testing::ValuesIn(bad_terrains),
                         [](const auto& one) { return std::string(one.param.name); });

class SurveyProject : public testing_tools::InputFolder {
 protected:
  [[nodiscard]] Model model(const std::string& text) {
    write("slope.toml", text);
    warnings_ = Problems{};
    return build_model(read_project(path("slope.toml")).project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& text) {
    return refusal_of([&] { static_cast<void>(model(text)); });
  }
};

/// A plane that falls to the east by 1 in 2, as points of a grid.
std::string plane_of_points() {
  std::string text = "x,y,z\n";
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 20; ++j) text += fmt::format("{},{},{}\n", 5 * i, 5 * j, 1500 - 2.5 * i);
  }
  return text;
}

TEST_F(SurveyProject, TrajectoriesAreAsOnTheSamePlaneOfTriangles) {
  write("p.csv", plane_of_points());
  const Model survey = model("[terrain]\npoints = \"p.csv\"\ncrs = \"local\"\n" + tables_after_terrain);
  EXPECT_EQ(warnings_.text(), "");
  EXPECT_THAT(
      survey.terrain_report,
      HasSubstr("p.csv: 861 points\nsurvey: 861 points, placed to 0.00048 mm\ntriangulated: 1600 triangles; median "
                "side 5 m, longest 7.071 m, at (2.500, 2.500, 1498.750)\n"));
  const Model mesh = model(
      "[terrain]\nvertices = [[0,0,1500],[200,0,1400],[200,100,1400],[0,100,1500]]\ntriangles = [[0,1,2],[0,2,3]]\n" +
      tables_after_terrain);
  Simulator on_survey(survey), on_mesh(mesh);
  for (std::uint64_t rock = 0; rock < 10; ++rock) {
    const Vec3 a = survey.frame.global_from_local(on_survey.simulate(rock, false).outcome.end.position);
    const Vec3 b = mesh.frame.global_from_local(on_mesh.simulate(rock, false).outcome.end.position);
    EXPECT_LT((a - b).norm(), 1e-6) << rock;
    EXPECT_GT(a.x(), 20);
  }
}

// The manual, section 2: three closed polylines, as polygons merged into one surface.
const std::string bowl_of_polylines = R"([terrain]
polylines = [
  [[-10, 10, 16.32993], [10, 10, 16.32993], [0, 4.226497, 0], [-10, 10, 16.32993]],
  [[-10, 10, 16.32993], [0, -7.32051, 16.32993], [0, 4.226497, 0], [-10, 10, 16.32993]],
  [[10, 10, 16.32993], [0, -7.32051, 16.32993], [0, 4.226497, 0], [10, 10, 16.32993]],
]
)";

std::string published_bowl(std::string_view without) {
  std::ifstream in(talus::places::in_source("/verification/2-bowl-lumped-mass/bowl.toml"));
  std::string text, line;
  while (std::getline(in, line)) {
    if (!line.starts_with(without)) text += line + '\n';
  }
  return text;
}

#ifdef TALUS_HAS_GDAL
TEST_F(SurveyProject, LinesWithoutHeightsLieOnThePoints) {
  write("p.csv", plane_of_points());
  testing_tools::add_layer(path("soft.gpkg"), "soft", "", "name",
                           {{"LINESTRING (12 13, 150 81)", "a"}, {"LINESTRING (20 90, 60 15, 100 90)", "b"}});
  const std::string terrain = "[terrain]\npoints = \"p.csv\"\nlines = \"soft.gpkg\"\ncrs = \"local\"\n";
  const Model draped = model(terrain + tables_after_terrain);
  EXPECT_EQ(warnings_.text(), "");
  const auto& surface = std::get<TriangleMesh>(*draped.surface);
  for (const Vec2& at : {Vec2(12, 13), Vec2(81, 47), Vec2(60, 15), Vec2(150, 81), Vec2(7, 93)}) {
    const Vec3 local = draped.frame.local_from_global(Vec3(at.x(), at.y(), 0));
    ASSERT_TRUE(surface.elevation(local.x(), local.y()));
    EXPECT_NEAR(*surface.elevation(local.x(), local.y()) + draped.frame.origin.z(), 1500 - at.x() / 2, 1e-6);
  }
  std::filesystem::remove(path("soft.gpkg"));
  testing_tools::add_layer(path("soft.gpkg"), "soft", "", "name", {{"LINESTRING (12 13, 250 81)", "a"}});
  EXPECT_EQ(
      refusal(terrain + tables_after_terrain),
      "slope.toml:2: [terrain]: points p.csv: feature 1 of the lines has no heights (it reaches beyond the points at "
      "(250, 81)). Cut it to the area of the points, or give it heights");
}
#endif

TEST_F(SurveyProject, TheManualsBowlFromItsPolylines) {
  const Model published = model(published_bowl("#"));
  std::string text = published_bowl("vertices");
  text.erase(text.find("triangles = "), text.find('\n', text.find("triangles = ")) - text.find("triangles = "));
  text.replace(text.find("[terrain]\n"), 10, bowl_of_polylines);
  const Model merged = model(text);
  EXPECT_THAT(merged.terrain_report, HasSubstr("polygons: 3, cut into 3 triangles; corners lie within 0 m of"));
  EXPECT_THAT(merged.terrain_report, HasSubstr("3 facets, 4 vertices, 1 component (0 closed), 3 boundary edges"));
  EXPECT_THAT(merged.terrain_report, HasSubstr("welded: 5 vertices"));

  const auto& first = std::get<TriangleMesh>(*published.surface);
  const auto& second = std::get<TriangleMesh>(*merged.surface);
  ASSERT_EQ(second.facet_count(), 3U);
  const auto normals = [](const TriangleMesh& mesh) {
    std::vector<std::array<double, 3>> out;
    for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) {
      const Vec3 n = mesh.normal({k});
      out.push_back({n.x(), n.y(), n.z()});
    }
    std::sort(out.begin(), out.end());
    return out;
  };
  EXPECT_EQ(normals(first), normals(second));

  // The path, from which the table of the case follows, is bit-identical.
  Simulator one(published), other(merged);
  static_cast<void>(one.simulate(0, true));
  static_cast<void>(other.simulate(0, true));
  ASSERT_EQ(one.log().rows.size(), other.log().rows.size());
  ASSERT_GE(one.log().rows.size(), 6U);
  for (std::size_t k = 0; k < one.log().rows.size(); ++k) {
    EXPECT_EQ(one.log().rows[k].motion.position, other.log().rows[k].motion.position) << k;
    EXPECT_EQ(one.log().rows[k].motion.velocity, other.log().rows[k].motion.velocity) << k;
    EXPECT_EQ(one.log().rows[k].motion.spin, other.log().rows[k].motion.spin) << k;
  }
}

TEST_F(SurveyProject, VerticesWithinTheToleranceAreMerged) {
  std::string apart = bowl_of_polylines;
  apart.replace(apart.rfind("4.226497"), 8, "4.226997");
  const std::string seeder = "[[material]]\nname = \"Rock\"\n[[seeder]]\nposition = [0, 0, 20]\nmass_kg = 1000\n";
  EXPECT_THAT(model(apart + seeder).terrain_report, HasSubstr("4 vertices, 1 component (0 closed), 3 boundary edges"));
  EXPECT_THAT(model(apart + "merge_tolerance_m = 0.0001\n" + seeder).terrain_report,
              HasSubstr("5 vertices, 2 components (0 closed), 7 boundary edges"));
}

// A plane of three polygons, with a corner of two of them on a side of the third: rocks slide past it to the rim. If
// the corner is not joined, they leave their facet at the crack and land on the plane beyond it.
TEST_F(SurveyProject, RocksSlidePastACornerOnASide) {
  const std::string slope = R"([terrain]
polylines = [[[0, 0, 100], [10, 0, 90], [10, 10, 90], [0, 10, 100], [0, 0, 100]],
             [[10, 0, 90], [20, 0, 80], [20, 5, 80], [10, 5, 90], [10, 0, 90]],
             [[10, 5, 90], [20, 5, 80], [20, 10, 80], [10, 10, 90], [10, 5, 90]]]
)";
  const std::string rocks = R"([[material]]
name = "Rock"
friction_angle_deg = 5
[[seeder]]
position = [5, 4, "surface"]
mass_kg = 100
horizontal_velocity_m_s = 3
)";
  const auto end_x = [&](const Model& slide) {
    Simulator one(slide);
    static_cast<void>(one.simulate(0, true));
    return slide.frame.global_from_local(one.log().rows.back().motion.position).x();
  };
  const Model joined = model(slope + rocks);
  EXPECT_THAT(joined.terrain_report, HasSubstr("joined: 1 corner on the side of another facet"));
  EXPECT_NEAR(end_x(joined), 20, 1e-6);
  const Model cracked = model(slope + "merge_tolerance_m = 0\n" + rocks);
  EXPECT_THAT(cracked.terrain_report, HasSubstr("warning: 3 boundary edges lie within 0.01 m of another facet"));
  EXPECT_NEAR(end_x(cracked), 20, 1e-6);
}

TEST_F(SurveyProject, RefusesPolylinesThatCrossThemselves) {
  EXPECT_EQ(
      refusal("[terrain]\npolylines = [[[0, 0, 0], [10, 10, 0], [10, 0, 0], [0, 4, 0], [0, 0, 0]]]\n" +
              tables_after_terrain),
      "slope.toml: terrain: polylines[0] crosses itself at (2.857, 2.857, 0.000) (it cannot be triangulated). Are "
      "its vertices in order?");
  // Two halves with opposite areas define no plane in which to find the crossing.
  EXPECT_EQ(refusal("[terrain]\npolylines = [[[0, 0, 0], [10, 10, 0], [10, 0, 0], [0, 10, 0], [0, 0, 0]]]\n" +
                    tables_after_terrain),
            "slope.toml: terrain: polylines[0] has no area (its corners lie on one line, its border doubles back, or "
            "its sides cross)");
}

TEST_F(SurveyProject, RefusesMissingFiles) {
  EXPECT_EQ(
      refusal("[terrain]\npoints = \"p.csv\"\nlines = \"l.gpkg\"\nboundary = \"b.gpkg\"\n" + tables_after_terrain),
      "slope.toml:2: [terrain]: points is \"p.csv\" (there is no such file). The path is relative to the "
      "project file\n"
      "slope.toml:3: [terrain]: lines is \"l.gpkg\" (there is no such file). The path is relative to the "
      "project file\n"
      "slope.toml:4: [terrain]: boundary is \"b.gpkg\" (there is no such file). The path is relative to the "
      "project file");
}

TEST_F(SurveyProject, RefusesAnUnknownCoordinateSystem) {
  write("p.csv", plane_of_points());
  EXPECT_EQ(refusal("[terrain]\npoints = \"p.csv\"\ncrs = \"EPSG:99999999\"\n" + tables_after_terrain),
            "slope.toml: [terrain]: crs is \"EPSG:99999999\" (this coordinate system is not known). Use for example "
            "\"EPSG:31287\", or \"local\"");
}

#ifdef TALUS_HAS_GDAL

TEST_F(SurveyProject, LinesBoundaryAndCoordinateSystemComeFromFiles) {
  std::string points = "x y z\n";
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 20; ++j) points += fmt::format("{} {} {}\n", 400000 + 5 * i, 300000 + 5 * j, 1500 - 2.5 * i);
  }
  write("p.xyz", points);
  testing_tools::add_layer(folder_ / "survey.gpkg", "edges", "EPSG:31287", "name",
                           {{"LINESTRING Z (400010 300010.5 1500, 400150 300010.5 1450)", "wall"}});
  testing_tools::add_layer(
      folder_ / "survey.gpkg", "area", "EPSG:31287", "name",
      {{"POLYGON ((400000 300000, 400200 300000, 400200 300060, 400000 300060, 400000 300000))", ""}});
  const std::string seeder =
      "[[material]]\nname = \"Rock\"\n[[seeder]]\nposition = [400020, 300030]\nheight_above_m = 5\nmass_kg = 1000\n";
  const Model built = model(
      "[terrain]\npoints = \"p.xyz\"\nlines = \"survey.gpkg\"\nlines_layer = \"edges\"\nboundary = \"survey.gpkg\"\n"
      "boundary_layer = \"area\"\ncrs = \"EPSG:31287\"\n" +
      seeder);
  EXPECT_EQ(warnings_.text(), "");
  EXPECT_THAT(built.crs_wkt, ::testing::StartsWith("PROJCRS["));
  const auto& mesh = std::get<TriangleMesh>(*built.surface);
  const Vec3& origin = built.frame.origin;
  EXPECT_NEAR(*mesh.elevation(400080 - origin.x(), 300010.5 - origin.y()) + origin.z(), 1475, 1e-6);
  EXPECT_NEAR(mesh.bounds().high.y() + origin.y(), 300060, 1e-6);
}

#endif

}  // namespace
}  // namespace talus::project
