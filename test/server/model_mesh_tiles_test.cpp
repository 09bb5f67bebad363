// A mesh in tiles and levels of detail: the finest are the engine's triangles, the coarse ones are close to them.

#include "server/served_models.hpp"

#include <cmath>
#include <fstream>
#include <set>

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;

constexpr int nodes = 200;

class ModelMeshTiles : public testing_tools::ServedModels {
 protected:
  void SetUp() override {
    std::ofstream file(path("hill.obj"));
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i) file << "v " << i << ' ' << j << ' ' << 10 * std::sin(0.05 * i) + 0.5 * j << '\n';
    for (int j = 0; j + 1 < nodes; ++j) {
      for (int i = 0; i + 1 < nodes; ++i) {
        const int k = j * nodes + i + 1;
        file << "f " << k << ' ' << k + 1 << ' ' << k + nodes + 1 << "\nf " << k << ' ' << k + nodes + 1 << ' '
             << k + nodes << '\n';
      }
    }
  }
  const std::string text = R"([terrain]
mesh = "hill.obj"
[[material]]
name = "Rock"
[[seeder]]
position = [80, 80, "surface"]
mass_kg = 1000
)";
};

TEST_F(ModelMeshTiles, AreTheTrianglesOfTheEngineAtTheFinestLevel) {
  const Json model = model_of(text);
  const Json tiles = get(at(model, "tiles")).json();
  ASSERT_EQ(tiles["levels"].size(), 4U);
  const Model ours = built(text);
  const auto& mesh = std::get<TriangleMesh>(*ours.surface);
  std::set<std::uint32_t> seen;
  const Json& finest = tiles["levels"][0];
  for (int row = 0; row < finest["rows"]; ++row) {
    for (int column = 0; column < finest["columns"]; ++column) {
      const ArraysOf tile(get(at(model, "tiles/0/" + std::to_string(column) + "/" + std::to_string(row))));
      const auto positions = tile.get<float>("positions", "f32");
      const auto triangles = tile.get<std::uint32_t>("triangles", "u32");
      const auto facets = tile.get<std::uint32_t>("facets", "u32");
      ASSERT_EQ(triangles.size(), 3 * facets.size());
      EXPECT_LT(facets.size(), mesh.facet_count() / 4);
      for (std::size_t k = 0; k < facets.size(); ++k) {
        seen.insert(facets[k]);
        for (std::size_t c = 0; c < 3; ++c)
          for (int i = 0; i < 3; ++i)
            ASSERT_EQ(positions[3 * triangles[3 * k + c] + i], static_cast<float>(mesh.triangle({facets[k]})[c][i]));
      }
    }
  }
  EXPECT_EQ(seen.size(), mesh.facet_count());
  EXPECT_EQ(get(at(model, "tiles/0/" + finest["columns"].dump() + "/0")).status, 404);
  EXPECT_EQ(get(at(model, "tiles/4/0/0")).status, 404);
}

TEST_F(ModelMeshTiles, AreCloseToTheTerrainAtCoarseLevels) {
  const Json model = model_of(text);
  const Json tiles = get(at(model, "tiles")).json();
  const Model ours = built(text);
  const auto& mesh = std::get<TriangleMesh>(*ours.surface);
  const Json& coarsest = tiles["levels"].back();
  EXPECT_EQ(coarsest["columns"], 1);
  EXPECT_EQ(coarsest["rows"], 1);
  const double cell = tiles["cell"][0].get<double>() * coarsest["stride"].get<double>();
  const ArraysOf tile(get(at(model, "tiles/3/0/0")));
  const auto positions = tile.get<float>("positions", "f32");
  const auto triangles = tile.get<std::uint32_t>("triangles", "u32");
  EXPECT_LT(triangles.size() / 3, mesh.facet_count() / 2);
  double area = 0;
  const auto corner = [&](std::size_t k) {
    const float* p = &positions[3 * triangles[k]];
    return Vec3(p[0], p[1], p[2]);
  };
  for (std::size_t k = 0; k < triangles.size(); k += 3)
    area += (corner(k + 1) - corner(k)).cross(corner(k + 2) - corner(k)).z() / 2;
  EXPECT_NEAR(area, (nodes - 1) * (nodes - 1), 0.1 * (nodes - 1) * (nodes - 1)) << "no holes; the edge may be cut";
  for (std::size_t k = 0; k < positions.size(); k += 3) {
    const auto ground = mesh.elevation(positions[k], positions[k + 1]);
    ASSERT_TRUE(ground);
    EXPECT_NEAR(positions[k + 2], *ground, cell);
  }
}

}  // namespace
}  // namespace talus
