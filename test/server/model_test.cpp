// Models for the page: problems that know their setting, and geometry that is the engine's to the last bit.

#include "server/served.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::Served;

const std::string section_text = R"(
[terrain]
section = [[0, 20], [10, 10], [30, 5]]
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[ground]
segments = ["Rock", "Soil"]
[[seeder]]
name = "Edge"
position = [1, 25]
rocks = 1
mass_kg = 1000
[[barrier]]
name = "Net"
line = 20
height_m = 4
inclination_deg = 30
capacity_kJ = 500
)";

const std::string mesh_text = R"(
[terrain]
section = [[1000, 20], [1010, 10], [1030, 5]]
width_m = 40
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[ground]
segments = ["Rock", "Soil"]
[[seeder]]
name = "Edge"
type = "line"
points = [[1001, 5, "surface"], [1001, 35, "surface"]]
rocks = 10
mass_kg = 1000
[[seeder]]
name = "Area"
type = "polygon"
polygon = [[1002, 2], [1008, 2], [1008, 30], [1002, 30]]
cell_m = 1
rocks = 5000
mass_kg = 1000
[[barrier]]
name = "Net"
line = [[1020, 2], [1020, 20], [1025, 38]]
height_m = 4
inclination_deg = -20
[[collector]]
name = "Road"
line = [[1028, 2], [1028, 38]]
height_m = 3
)";

/// A raster of text, from a function of column and row from the south-west.
template <class Height>
std::string ascii_grid(int columns, int rows, double cell, Height&& height) {
  std::string text = fmt::format(
      "ncols {}\nnrows {}\nxllcorner 5000\nyllcorner 9000\ncellsize {}\nNODATA_value -9999\n", columns, rows, cell);
  for (int row = rows - 1; row >= 0; --row) {
    for (int column = 0; column < columns; ++column) text += fmt::format("{} ", height(column, row));
    text += '\n';
  }
  return text;
}

class ModelOf : public Served {
 protected:
  [[nodiscard]] Json posted(const std::string& text) const {
    const Reply reply = post("/api/model", {{"file", "slope.toml"}, {"text", text}});
    EXPECT_EQ(reply.status, 200) << reply.body;
    return reply.json();
  }
  /// Its model, which must be there.
  [[nodiscard]] Json model_of(const std::string& text) const {
    const Json answer = posted(text);
    EXPECT_FALSE(answer["model"].is_null()) << answer.dump(1);
    return answer["model"];
  }
  [[nodiscard]] static std::string at(const Json& model, const std::string& what) {
    return "/api/models/" + model["id"].get<std::string>() + "/" + what;
  }
  [[nodiscard]] Model built(const std::string& text) const {
    project::Reading reading = project::read_project_text(text, path("slope.toml"));
    return project::build_model(reading.project, reading.warnings);
  }
  /// "path: text" of each problem.
  [[nodiscard]] std::vector<std::string> problems_of(const std::string& text) const {
    const Json answer = posted(text);
    std::vector<std::string> list;
    for (const Json& problem : answer["problems"])
      list.push_back(problem["path"].get<std::string>() + ": " + problem["text"].get<std::string>());
    return list;
  }
  [[nodiscard]] std::vector<std::string> paths_of(const std::string& text) const {
    const Json answer = posted(text);
    std::vector<std::string> list;
    for (const Json& problem : answer["problems"]) list.push_back(problem["path"].get<std::string>());
    return list;
  }
  static std::string with(std::string text, const std::string& what, const std::string& instead) {
    const std::size_t begin = text.find(what);
    EXPECT_NE(begin, std::string::npos) << what;
    return text.replace(begin, what.size(), instead);
  }

#ifdef TALUS_HAS_GDAL
  /// A slope with a hole, and the text of a project on it.
  std::string raster_project(int columns, int rows) const {
    write("dem.asc", ascii_grid(columns, rows, 10, [&](int column, int row) {
            return column == 3 && row == 2 ? -9999.0 : 500 + column * 7.25 - row * 3.5 + (column * row % 5) * 0.25;
          }));
    return R"(
[terrain]
raster = "dem.asc"
[[material]]
name = "Rock"
[[seeder]]
position = [5020, 9020, "surface"]
mass_kg = 1000
)";
  }
#endif
};

TEST_F(ModelOf, NamesTheSettingOfEachProblem) {
  EXPECT_EQ(problems_of(with(section_text, "mass_kg = 1000", "mass_kg = { mean = -1 }")),
            (std::vector<std::string>{"seeder.0.mass_kg.mean: slope.toml:14: seeder \"Edge\": mass_kg mean is -1 (a "
                                      "rock has mass; expected 1e-9 to 1e12)"}));
  EXPECT_EQ(paths_of(with(section_text, "[30, 5]", "[30, \"five\"]")), std::vector<std::string>{"terrain.section.2.1"});
  EXPECT_EQ(paths_of(with(section_text, "name = \"Soil\"", "nam = \"Soil\"")),
            std::vector<std::string>{"material.1.nam"});
  EXPECT_EQ(paths_of(with(section_text, "\"Soil\"]", "\"Sol\"]")), std::vector<std::string>{"ground.segments.1"});
  EXPECT_EQ(paths_of(with(section_text, "[[seeder]]", "[[seder]]")), (std::vector<std::string>{"seeder", "seder"}));
  EXPECT_EQ(paths_of(section_text + "[analysis]\nrn_mass_scale_kg = 10\n"),
            std::vector<std::string>{"analysis.rn_mass_scale_kg"});
  EXPECT_EQ(paths_of(with(section_text, "mass_kg = 1000", "\"a.b\" = 1\nmass_kg = 1000")),
            std::vector<std::string>{"seeder.0.\"a.b\""});
}

TEST_F(ModelOf, NamesTheKeyThatIsMissing) {
  EXPECT_EQ(paths_of(with(section_text, "position = [1, 25]\n", "")), std::vector<std::string>{"seeder.0.position"});
  EXPECT_EQ(paths_of(with(section_text, "height_m = 4\n", "")), std::vector<std::string>{"barrier.0.height_m"});
  EXPECT_EQ(paths_of(with(mesh_text, "cell_m = 1\n", "")), std::vector<std::string>{"seeder.1.cell_m"});
}

TEST_F(ModelOf, NamesTheSettingOfWhatOnlyTheTerrainShows) {
  EXPECT_EQ(problems_of(with(section_text, "position = [1, 25]", "position = [100, 25]")),
            (std::vector<std::string>{"seeder.0: slope.toml:10: seeder \"Edge\": x = 100 is off the terrain (the "
                                      "section goes from x = 0 to 30)"}));
  EXPECT_EQ(paths_of(with(mesh_text, "line = [[1028, 2], [1028, 38]]", "line = [[28, 2], [28, 38]]")),
            std::vector<std::string>{"collector.0"});
  EXPECT_EQ(paths_of(with(mesh_text, "polygon = [[1002, 2], [1008, 2], [1008, 30], [1002, 30]]",
                          "polygon = [[2, 2], [8, 2], [8, 30], [2, 30]]")),
            std::vector<std::string>{"seeder.1"});
}

TEST_F(ModelOf, NamesTheSettingOfAFileThatIsWrong) {
  write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  const std::string text =
      "[terrain]\nmesh = \"bad.obj\"\n[[material]]\nname = \"A\"\n[[seeder]]\nposition = [0, 0, 1]\nmass_kg = 1\n";
  const Json answer = posted(text);
  EXPECT_TRUE(answer["model"].is_null());
  ASSERT_FALSE(answer["problems"].empty());
  EXPECT_EQ(answer["problems"][0]["file"], "slope.toml");
  EXPECT_EQ(answer["problems"][0]["line"], 2);
  EXPECT_EQ(answer["problems"][0]["path"], "terrain.mesh");
}

TEST_F(ModelOf, SaysWhereATextIsNoToml) {
  const Json answer = posted("[terrain\n");
  ASSERT_EQ(answer["problems"].size(), 1U);
  EXPECT_EQ(answer["problems"][0]["line"], 1);
  EXPECT_EQ(answer["problems"][0]["path"], "");
  EXPECT_TRUE(answer["model"].is_null());
}

TEST_F(ModelOf, TellsOfASection) {
  const Json model = model_of(section_text);
  EXPECT_EQ(model["dimension"], 2);
  EXPECT_EQ(model["kind"], "section");
  EXPECT_EQ(model["rocks"], 1);
  EXPECT_TRUE(model["crs"].is_null());
  EXPECT_EQ(model["materials"], (Json{"Rock", "Soil"}));
  EXPECT_EQ(model["bounds"], (Json{{"min", {0.0, 0.0, 5.0}}, {"max", {30.0, 0.0, 20.0}}}));
  EXPECT_EQ(model["seeders"][0]["points"], Json::parse("[[1.0, 0.0, 25.0]]"));
  EXPECT_EQ(model["project"]["seeder"][0]["density_kg_m3"]["mean"], 2700.0);
  const Json& net = model["barriers"][0];
  EXPECT_EQ(net["path"], "barrier.0");
  EXPECT_EQ(net["capacity_kJ"], 500.0);
  EXPECT_EQ(net["foot"], Json::parse("[[20.0, 0.0, 7.5]]"));
  // Positive leans towards +x.
  EXPECT_NEAR(net["top"][0][0].get<double>(), 20 + 4 * std::sin(std::numbers::pi / 6), 1e-12);
  EXPECT_NEAR(net["top"][0][2].get<double>(), 7.5 + 4 * std::cos(std::numbers::pi / 6), 1e-12);

  const Reply profile = get(at(model, "profile"));
  EXPECT_EQ(profile.json()["vertices"], Json::parse("[[0.0, 20.0], [10.0, 10.0], [30.0, 5.0]]"));
  EXPECT_EQ(profile.json()["materials"], (Json{0, 1}));
  EXPECT_EQ(get(at(model, "mesh")).status, 404);
  EXPECT_EQ(get(at(model, "tiles")).status, 404);
  EXPECT_EQ(post(at(model, "section"), {{"line", {{0, 0}, {1, 1}}}}).status, 404);
}

TEST_F(ModelOf, CountsSegmentsAsTheProjectDoes) {
  const std::string backwards = with(section_text, "[[0, 20], [10, 10], [30, 5]]", "[[30, 5], [10, 10], [0, 20]]");
  const Json given = get(at(model_of(section_text), "profile")).json();
  EXPECT_EQ(given["segments"], (Json{0, 1}));
  const Json profile = get(at(model_of(backwards), "profile")).json();
  EXPECT_EQ(profile["vertices"], given["vertices"]) << "from left to right";
  EXPECT_EQ(profile["segments"], (Json{1, 0}));
  EXPECT_EQ(profile["materials"], (Json{1, 0})) << "rock, then soil, as the section goes";

  const ArraysOf extruded(get(at(model_of(mesh_text), "mesh")));
  EXPECT_EQ(extruded.header["parts"], 2);
  EXPECT_EQ(extruded.get<std::uint32_t>("parts", "u32"), (std::vector<std::uint32_t>{0, 0, 1, 1}));
}

TEST_F(ModelOf, CountsTrianglesAsTheProjectDoesWhereMendingDropsSome) {
  // The second triangle repeats the first, the fourth is no more than a line.
  const std::string text = R"(
[terrain]
vertices = [[0, 0, 0], [10, 0, 0], [10, 10, 5], [0, 10, 5], [20, 0, 0]]
triangles = [[0, 1, 2], [0, 1, 2], [0, 2, 3], [0, 1, 4], [1, 4, 2]]
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[ground]
triangles = [0, 0, 1, 0, 1]
[[seeder]]
position = [5, 2, "surface"]
mass_kg = 1000
)";
  const Json model = model_of(text);
  EXPECT_EQ(model["facets"], 3);
  const ArraysOf mesh(get(at(model, "mesh")));
  EXPECT_EQ(mesh.header["parts"], 5);
  EXPECT_EQ(mesh.get<std::uint32_t>("parts", "u32"), (std::vector<std::uint32_t>{0, 2, 4}));
  EXPECT_EQ(mesh.get<std::uint8_t>("materials", "u8"), (std::vector<std::uint8_t>{0, 1, 1}));
}

TEST_F(ModelOf, HasTheTrianglesOfTheEngine) {
  const Json model = model_of(mesh_text);
  EXPECT_EQ(model["kind"], "mesh");
  EXPECT_EQ(model["facets"], 4);
  const Reply reply = get(at(model, "mesh"));
  ASSERT_EQ(reply.status, 200);
  const ArraysOf arrays(reply);
  const auto positions = arrays.get<float>("positions", "f32");
  const auto triangles = arrays.get<std::uint32_t>("triangles", "u32");
  const auto materials = arrays.get<std::uint8_t>("materials", "u8");
  EXPECT_EQ(positions.size(), 3 * 6U);  // six vertices, shared

  const Model ours = built(mesh_text);
  const auto& mesh = std::get<TriangleMesh>(ours.surface);
  ASSERT_EQ(triangles.size(), 3 * mesh.facet_count());
  ASSERT_EQ(materials.size(), mesh.facet_count());
  for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) {
    EXPECT_EQ(materials[k], ours.ground.material_of(mesh.source({k})).index);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& corner = mesh.triangle({k})[c];
      for (int i = 0; i < 3; ++i) EXPECT_EQ(positions[3 * triangles[3 * k + c] + i], static_cast<float>(corner[i]));
    }
  }
  for (int i = 0; i < 3; ++i) EXPECT_EQ(arrays.header["origin"][i].get<double>(), ours.frame.origin[i]);
}

TEST_F(ModelOf, ShowsBarriersAsTheyStand) {
  const Json model = model_of(mesh_text);
  const Model ours = built(mesh_text);
  ASSERT_EQ(model["barriers"].size(), 2U);
  EXPECT_TRUE(model["barriers"][0]["capacity_kJ"].is_null());
  EXPECT_EQ(model["barriers"][1]["kind"], "collector");
  EXPECT_EQ(model["barriers"][1]["path"], "collector.0");
  for (std::size_t b = 0; b < 2; ++b) {
    const Json &foot = model["barriers"][b]["foot"], &top = model["barriers"][b]["top"];
    ASSERT_EQ(foot.size(), top.size());
    // Each panel lies between two neighbouring pairs.
    std::size_t at_pair = 0;
    for (const Panel& panel : ours.barriers[b].panels()) {
      const auto is_here = [&](const Json& p, const Vec3& local) {
        const Vec3 q = ours.frame.global_from_local(local);
        return p[0] == q.x() && p[1] == q.y() && p[2] == q.z();
      };
      const Vec3 rise = panel.height * panel.up, end = panel.foot + panel.length * panel.along;
      while (at_pair + 1 < foot.size() &&
             !(is_here(foot[at_pair], panel.foot) && is_here(top[at_pair], panel.foot + rise)))
        ++at_pair;
      ASSERT_LT(at_pair + 1, foot.size());
      EXPECT_LT(
          (Vec3(foot[at_pair + 1][0], foot[at_pair + 1][1], foot[at_pair + 1][2]) - ours.frame.global_from_local(end))
              .norm(),
          1e-9);
      EXPECT_LT((Vec3(top[at_pair + 1][0], top[at_pair + 1][1], top[at_pair + 1][2]) -
                 ours.frame.global_from_local(end + rise))
                    .norm(),
                1e-9);
    }
  }
}

TEST_F(ModelOf, ShowsPlacesWhereRocksStart) {
  const Json model = model_of(mesh_text);
  const Model ours = built(mesh_text);
  Simulator simulator(ours);
  const Json& edge = model["seeders"][0];
  ASSERT_EQ(edge["points"].size(), 10U);
  for (std::size_t k = 0; k < 10; ++k) {
    const Vec3 start = ours.frame.global_from_local(simulator.simulate(k, false).outcome.start.position);
    EXPECT_EQ(edge["points"][k], (Json{start.x(), start.y(), start.z()}));
  }
  for (const Json& p : edge["lines"][0]) EXPECT_NEAR(p[2].get<double>(), 19, 1e-12);  // on the ground at x = 1001
  const Json& area = model["seeders"][1];
  EXPECT_EQ(area["first_rock"], 10);
  EXPECT_EQ(area["path"], "seeder.1");
  ASSERT_EQ(area["points"].size(), 2000U);
  std::set<double> rows;
  for (const Json& p : area["points"]) {
    EXPECT_GE(p[0].get<double>(), 1002);
    EXPECT_LE(p[0].get<double>(), 1008);
    EXPECT_NEAR(p[2].get<double>(), 20 - (p[0].get<double>() - 1000), 1e-9);
    rows.insert(std::floor(p[1].get<double>()));
  }
  EXPECT_EQ(rows.size(), 28U);  // from all over the area, not only from where the first rocks start
}

TEST_F(ModelOf, ShowsAreasOnTheGround) {
  const Json model = model_of(std::string(mesh_text) +
                              "[[area]]\nname = \"Fan\"\nmaterial = \"Rock\"\n"
                              "polygon = [[1002, 2], [1006, 2], [1006, 300]]\n");
  ASSERT_EQ(model["areas"].size(), 1U);
  const Json& area = model["areas"][0];
  EXPECT_EQ(area["name"], "Fan");
  EXPECT_EQ(area["path"], "area.0");
  EXPECT_EQ(model["materials"][area["material"].get<std::size_t>()], "Rock");
  ASSERT_EQ(area["sides"].size(), 3U);  // the parts of them that have ground below
  for (const Json& side : area["sides"]) {
    for (const Json& p : side) EXPECT_NEAR(p[2].get<double>(), 20 - (p[0].get<double>() - 1000), 1e-9);
  }
  EXPECT_EQ(area["sides"][0].front()[0], 1002);
  EXPECT_EQ(area["sides"][0].back()[0], 1006);
}

TEST_F(ModelOf, IsTheSameForTheSameText) {
  const std::string id = model_of(section_text)["id"];
  EXPECT_EQ(model_of(section_text)["id"], id);
  const Json other = model_of(section_text + "# changed\n");
  EXPECT_NE(other["id"], id);
  EXPECT_EQ(other["files"], model_of(section_text)["files"]);
}

TEST_F(ModelOf, IsGoneAfterAFewOthers) {
  const Json first = model_of(section_text);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(get(at(first, "profile")).status, 200);
    static_cast<void>(model_of(section_text + fmt::format("# {}\n", k)));
  }
  const Reply gone = get(at(first, "profile"));
  EXPECT_EQ(gone.status, 404);
  EXPECT_EQ(gone.problem(), first["id"].get<std::string>() +
                                ": there is no such model (only the last few are kept). Post the project again");
  for (const std::string what : {"mesh", "profile", "tiles", "tiles/0/0/0"})
    EXPECT_EQ(get("/api/models/0123456789abcdef/" + what).status, 404) << what;
  EXPECT_EQ(post("/api/models/0123456789abcdef/elevations", {{"points", Json::array()}}).status, 404);
}

TEST_F(ModelOf, IsBuiltAnewWhenItsFilesChange) {
  const auto mesh = [&](double top) {
    write("slope.obj", fmt::format("v 0 0 {0}\nv 10 0 0\nv 10 10 0\nv 0 10 {0}\nf 1 2 3\nf 1 3 4\n", top));
  };
  const std::string text =
      "[terrain]\nmesh = \"slope.obj\"\n[[material]]\nname = \"A\"\n[[seeder]]\n"
      "position = [1, 1, \"surface\"]\nmass_kg = 1\n";
  mesh(5);
  const Json before = model_of(text);
  mesh(6.5);
  const Json after = model_of(text);
  EXPECT_NE(before["id"], after["id"]);
  EXPECT_NE(before["files"], after["files"]);
  EXPECT_EQ(before["bounds"]["max"][2], 5.0);
  EXPECT_EQ(after["bounds"]["max"][2], 6.5);
}

TEST_F(ModelOf, CanBeUsedWhileOthersAreBuilt) {
  std::vector<std::thread> pages;
  std::atomic<int> wrong{0};
  for (int page = 0; page < 6; ++page) {
    pages.emplace_back([&, page] {
      for (int k = 0; k < 8; ++k) {
        const std::string text = mesh_text + fmt::format("# {} {}\n", page % 3, k % 5);
        const Reply reply = post("/api/model", {{"file", "slope.toml"}, {"text", text}});
        const Json model = reply.json()["model"];
        const int status = model.is_null() ? 0 : get(at(model, "mesh")).status;
        wrong += status == 200 || status == 404 ? 0 : 1;  // gone meanwhile is fine
      }
    });
  }
  for (std::thread& page : pages) page.join();
  EXPECT_EQ(wrong, 0);
}

TEST_F(ModelOf, KnowsElevations) {
  const Json model = model_of(mesh_text);
  const Reply reply = post(at(model, "elevations"), {{"points", {{1005, 20}, {1030, 40}, {999, 20}, {1010, 0}}}});
  EXPECT_EQ(reply.json()["z"], (Json{15.0, 5.0, nullptr, 10.0}));
  EXPECT_EQ(post(at(model, "elevations"), {{"points", {{1, 2, 3}}}}).problem(),
            "points[0]: is not understood (expected 2 numbers)");
  EXPECT_EQ(post(at(model, "elevations"), {{"points", {{1, nullptr}}}}).status, 400);
  EXPECT_EQ(post(at(model, "elevations"), {{"points", {{1e300, 0}}}}).status, 400);
  EXPECT_EQ(post(at(model, "elevations"), {{"points", 7}}).status, 400);
  EXPECT_EQ(post(at(model, "elevations"), Json::object()).problem(), "points: is missing");
  EXPECT_EQ(post(at(model_of(section_text), "elevations"), {{"points", {{20, 0}}}}).json()["z"], Json{7.5});
}

TEST_F(ModelOf, HasSectionsAlongALine) {
  const Json model = model_of(mesh_text);
  const Json section = post(at(model, "section"), {{"line", {{995, 20}, {1015, 20}, {1015, 50}}}}).json();
  const auto distance = section["distance_m"].get<std::vector<double>>();
  EXPECT_TRUE(std::is_sorted(distance.begin(), distance.end()));
  EXPECT_EQ(distance.front(), 0);
  EXPECT_EQ(section["z_m"][0], nullptr);
  bool has_break = false;
  for (std::size_t k = 0; k < distance.size(); ++k) {
    const double x = section["x_m"][k], y = section["y_m"][k];
    EXPECT_NEAR(distance[k], y == 20 ? x - 995 : 20 + y - 20, 1e-9);
    if (section["z_m"][k].is_null()) {
      EXPECT_TRUE(x < 1000 || y >= 40 - 1e-9);
    } else {
      EXPECT_NEAR(section["z_m"][k].get<double>(), x <= 1010 ? 20 - (x - 1000) : 10 - (x - 1010) / 4, 1e-4);
    }
    has_break = has_break || std::abs(x - 1010) < 1e-9;
  }
  EXPECT_TRUE(has_break);
  EXPECT_EQ(post(at(model, "section"), {{"line", {{995, 20}}}}).status, 400);
}

#ifdef TALUS_HAS_GDAL

TEST_F(ModelOf, HasTilesOfARaster) {
  const int columns = 300, rows = 70;
  const std::string text = raster_project(columns, rows);
  const Json model = model_of(text);
  EXPECT_EQ(model["kind"], "raster");
  const Model ours = built(text);
  const RasterGrid& grid = std::get<RasterSurface>(ours.surface).grid();
  const Json tiles = get(at(model, "tiles")).json();
  EXPECT_EQ(tiles["columns"], columns);
  EXPECT_EQ(tiles["rows"], rows);
  EXPECT_EQ(tiles["cell"], (Json{10.0, 10.0}));
  EXPECT_EQ(tiles["levels"], Json::parse(R"([{"stride": 1, "columns": 2, "rows": 1},
                                             {"stride": 2, "columns": 1, "rows": 1}])"));

  const auto node = [&](const ArraysOf& tile, int column, int row) {
    const double x =
        tile.header["origin"][0].get<double>() + column * tile.header["cell"][0].get<double>() - ours.frame.origin.x();
    const double y =
        tile.header["origin"][1].get<double>() + row * tile.header["cell"][1].get<double>() - ours.frame.origin.y();
    return std::pair(std::lround((x - grid.x0) / grid.dx), std::lround((y - grid.y0) / grid.dy));
  };
  std::set<std::pair<long, long>> seen;
  std::vector<float> last_of_first;
  for (const std::string which : {"0/0/0", "0/1/0", "1/0/0"}) {
    const Reply reply = get(at(model, "tiles/" + which));
    ASSERT_EQ(reply.status, 200);
    const ArraysOf tile(reply);
    const int wide = tile.header["columns"], high = tile.header["rows"];
    const auto heights = tile.get<float>("heights", "f32");
    ASSERT_EQ(heights.size(), static_cast<std::size_t>(wide * high));
    EXPECT_EQ(tile.get<std::uint8_t>("materials", "u8").size(), static_cast<std::size_t>((wide - 1) * (high - 1)));
    for (int row = 0; row < high; ++row) {
      for (int column = 0; column < wide; ++column) {
        const auto [i, j] = node(tile, column, row);
        const float ground = grid.z[grid.index(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))];
        const float sent = heights[static_cast<std::size_t>(row * wide + column)];
        if (std::isnan(ground)) {
          EXPECT_TRUE(std::isnan(sent));
        } else {
          EXPECT_EQ(sent, ground);
        }
        if (which[0] == '0') seen.emplace(i, j);
      }
    }
    EXPECT_EQ(tile.header["origin"][2], ours.frame.origin.z());
    if (which[0] == '1') {  // the whole raster, but for what is not a whole step
      EXPECT_EQ(node(tile, 0, 0), std::pair(0L, 0L));
      EXPECT_EQ(node(tile, wide - 1, high - 1), std::pair(columns - 2L, rows - 2L));
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(columns * rows));
  const ArraysOf first(get(at(model, "tiles/0/0/0"))), second(get(at(model, "tiles/0/1/0")));
  EXPECT_EQ(first.header["origin"][0].get<double>() + 256 * 10, second.header["origin"][0].get<double>());
  EXPECT_EQ(first.header["columns"], 257);  // neighbours share an edge
  EXPECT_TRUE(std::isnan(first.get<float>("heights", "f32")[2 * 257 + 3]));

  for (const std::string which : {"2/0/0", "0/2/0", "0/0/1", "0/999999999/0"})
    EXPECT_EQ(get(at(model, "tiles/" + which)).status, 404) << which;
  for (const std::string which : {"0/0/-1", "0/0/4294967296", "a/0/0", "0/0"})
    EXPECT_EQ(get(at(model, "tiles/" + which)).status, 404) << which;
}

TEST_F(ModelOf, HasTilesOfAStripNarrowerThanAStep) {
  const Json model = model_of(raster_project(2000, 3));
  const Json levels = get(at(model, "tiles")).json()["levels"];
  EXPECT_EQ(levels.back(), Json::parse(R"({"stride": 8, "columns": 1, "rows": 1})"));
  const ArraysOf tile(get(at(model, "tiles/3/0/0")));
  EXPECT_EQ(tile.header["rows"], 2);
  EXPECT_EQ(tile.header["cell"], (Json{80.0, 20.0}));
}

TEST_F(ModelOf, LeavesHolesOutOfTrianglesAndSections) {
  const std::string text = raster_project(8, 6);
  const Json model = model_of(text);
  const ArraysOf arrays(get(at(model, "mesh")));
  // Four of 35 cells have the node without data.
  EXPECT_EQ(arrays.get<std::uint32_t>("triangles", "u32").size(), 3 * 2 * (35 - 4U));
  for (const float x : arrays.get<float>("positions", "f32")) EXPECT_FALSE(std::isnan(x));

  const Json section = post(at(model, "section"), {{"line", {{5005, 9027}, {5075, 9027}}}}).json();
  const Model ours = built(text);
  const auto& raster = std::get<RasterSurface>(ours.surface);
  int holes = 0;
  for (std::size_t k = 0; k < section["x_m"].size(); ++k) {
    const double x = section["x_m"][k];
    if (section["z_m"][k].is_null()) {
      ++holes;
      EXPECT_NEAR(x, 5025, 1e-9);  // from the node before the one that is missing
    } else if (x > 5005 && x < 5075 && (x < 5024 || x > 5046)) {
      EXPECT_NEAR(section["z_m"][k].get<double>(),
                  *raster.elevation(x - ours.frame.origin.x(), 9027 - ours.frame.origin.y()), 1e-4);
    }
  }
  EXPECT_EQ(holes, 1);
  EXPECT_EQ(get(at(model, "tiles")).json()["levels"].size(), 1U);
}

TEST_F(ModelOf, SendsTilesInsteadOfMillionsOfTriangles) {
  const std::string text = raster_project(600, 600);
  const Json model = model_of(text);
  const Reply mesh = get(at(model, "mesh"));
  EXPECT_EQ(mesh.status, 404);
  EXPECT_EQ(mesh.problem(),
            "mesh: the raster has 358801 cells (it is sent as triangles up to 250000). Ask for its tiles");
  // A line along which the ground bends more often than a section has points.
  Json zigzag = Json::array();
  for (int k = 0; k < 40; ++k) zigzag.push_back({k % 2 == 0 ? 5005 : 10995, 9010 + 100 * k});
  const Json section = post(at(model, "section"), {{"line", zigzag}}).json();
  EXPECT_LE(section["z_m"].size(), 5000U);
  EXPECT_GE(section["z_m"].size(), 4500U);
}

#endif

}  // namespace
}  // namespace talus
