// The geometry of models for the page is that of the engine, bit by bit.

#include "server/served_models.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "talus/campaign/simulate.hpp"

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;

using testing_tools::mesh_text;
using testing_tools::section_text;

using ModelGeometry = testing_tools::ServedModels;

TEST_F(ModelGeometry, DescribesASection) {
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
  // A positive inclination leans towards +x.
  EXPECT_NEAR(net["top"][0][0].get<double>(), 20 + 4 * std::sin(std::numbers::pi / 6), 1e-12);
  EXPECT_NEAR(net["top"][0][2].get<double>(), 7.5 + 4 * std::cos(std::numbers::pi / 6), 1e-12);

  const Reply profile = get(at(model, "profile"));
  EXPECT_EQ(profile.json()["vertices"], Json::parse("[[0.0, 20.0], [10.0, 10.0], [30.0, 5.0]]"));
  EXPECT_EQ(profile.json()["materials"], (Json{0, 1}));
  EXPECT_EQ(get(at(model, "mesh")).status, 404);
  EXPECT_EQ(get(at(model, "tiles")).status, 404);
  EXPECT_EQ(post(at(model, "section"), {{"line", {{0, 0}, {1, 1}}}}).status, 404);
}

TEST_F(ModelGeometry, NumbersSegmentsAsTheProjectDoes) {
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

TEST_F(ModelGeometry, NumbersTrianglesAsTheProjectDoesIfCleaningDropsSome) {
  // The second triangle repeats the first, the fourth has no area.
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

TEST_F(ModelGeometry, HasTheTrianglesOfTheEngine) {
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
  const auto& mesh = std::get<TriangleMesh>(*ours.surface);
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

TEST_F(ModelGeometry, HasTheBarriersOfTheEngine) {
  const Json model = model_of(mesh_text);
  const Model ours = built(mesh_text);
  ASSERT_EQ(model["barriers"].size(), 2U);
  EXPECT_TRUE(model["barriers"][0]["capacity_kJ"].is_null());
  EXPECT_EQ(model["barriers"][1]["kind"], "collector");
  EXPECT_EQ(model["barriers"][1]["path"], "collector.0");
  for (std::size_t b = 0; b < 2; ++b) {
    const Json &foot = model["barriers"][b]["foot"], &top = model["barriers"][b]["top"];
    ASSERT_EQ(foot.size(), top.size());
    // Each panel lies between two neighbouring pairs of foot and top.
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

TEST_F(ModelGeometry, HasTheReleasePlacesOfTheEngine) {
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
  EXPECT_EQ(rows.size(), 28U);  // from the whole area, not only places of the first rocks
}

TEST_F(ModelGeometry, DrapesAreasOverTheGround) {
  const Json model = model_of(std::string(mesh_text) +
                              "[[area]]\nname = \"Fan\"\nmaterial = \"Rock\"\n"
                              "polygon = [[1002, 2], [1006, 2], [1006, 300]]\n"
                              "[[forest]]\nname = \"Wood\"\ndensity = \"open\"\nheight_m = 9\n"
                              "polygon = [[1002, 2], [1006, 2], [1006, 300]]\n");
  ASSERT_EQ(model["areas"].size(), 1U);
  ASSERT_EQ(model["forests"].size(), 1U);
  EXPECT_EQ(model["forests"][0]["name"], "Wood");
  EXPECT_EQ(model["forests"][0]["path"], "forest.0");
  EXPECT_EQ(model["forests"][0]["sides"], model["areas"][0]["sides"]);
  const Json& area = model["areas"][0];
  EXPECT_EQ(area["name"], "Fan");
  EXPECT_EQ(area["path"], "area.0");
  EXPECT_EQ(model["materials"][area["material"].get<std::size_t>()], "Rock");
  ASSERT_EQ(area["sides"].size(), 3U);  // of each side the part above ground
  for (const Json& side : area["sides"]) {
    for (const Json& p : side) EXPECT_NEAR(p[2].get<double>(), 20 - (p[0].get<double>() - 1000), 1e-9);
  }
  EXPECT_EQ(area["sides"][0].front()[0], 1002);
  EXPECT_EQ(area["sides"][0].back()[0], 1006);
}

TEST_F(ModelGeometry, HasElevations) {
  const Json model = model_of(mesh_text);
  const Reply reply = post(at(model, "elevations"), {{"points", {{1005, 20}, {1030, 40}, {999, 20}, {1010, 0}}}});
  EXPECT_EQ(reply.json()["z"], (Json{15.0, 5.0, nullptr, 10.0}));
  EXPECT_EQ(post(at(model, "elevations"), {{"points", {{1, 2, 3}}}}).problem(),
            "points[0]: is not valid (expected 2 numbers)");
  EXPECT_EQ(post(at(model, "elevations"), {{"points", {{1, nullptr}}}}).status, 400);
  EXPECT_EQ(post(at(model, "elevations"), {{"points", {{1e300, 0}}}}).status, 400);
  EXPECT_EQ(post(at(model, "elevations"), {{"points", 7}}).status, 400);
  EXPECT_EQ(post(at(model, "elevations"), Json::object()).problem(), "points: is missing");
  EXPECT_EQ(post(at(model_of(section_text), "elevations"), {{"points", {{20, 0}}}}).json()["z"], Json{7.5});
}

TEST_F(ModelGeometry, HasSectionsAlongALine) {
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
    const bool is_last = k + 1 == distance.size();
    if (section["z_m"][k].is_null() || is_last) {
      EXPECT_EQ(section["materials"][k], nullptr);
    } else if (distance[k + 1] > distance[k]) {
      const double middle = (x + section["x_m"][k + 1].get<double>()) / 2;
      EXPECT_EQ(section["materials"][k], middle < 1010 ? 0 : 1) << "rock down to x = 1010, then soil";
    }
    has_break = has_break || std::abs(x - 1010) < 1e-9;
  }
  EXPECT_TRUE(has_break);
  EXPECT_EQ(post(at(model, "section"), {{"line", {{995, 20}}}}).status, 400);
}

}  // namespace
}  // namespace talus
