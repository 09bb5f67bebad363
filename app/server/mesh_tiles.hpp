#pragma once
// A triangle mesh in tiles and levels of detail, for drawing the visible part. Level 0 has the mesh's own triangles. In
// each further level tiles are twice as wide, and all vertices within a cube of a grid become one, in their mean
// (Rossignac & Borrel, Multi-resolution 3D approximations for rendering complex scenes, 1993): triangles with two
// corners in a cube vanish. The last level is one tile.
//
// A triangle belongs to every tile that it overlaps or is close to. So neighbours overlap, which hides cracks between
// tiles of different levels.

#include <array>
#include <cstdint>
#include <mutex>
#include <vector>

#include "http/answer.hpp"
#include "talus/campaign/model.hpp"

namespace talus::server {

class MeshTiles {
 public:
  static constexpr std::uint32_t side = 48;                  // cells of a tile
  static constexpr double triangles_of_finest_tile = 4'000;  // on average

  /// `mesh` is the model's surface. The model must be alive at every call.
  MeshTiles(const Model& model, const TriangleMesh& mesh);

  [[nodiscard]] Json description() const;
  /// Refuses (404) a tile that does not exist. Thread-safe; the first call for a level makes it.
  [[nodiscard]] Answer tile(std::size_t level, std::uint32_t column, std::uint32_t row);

 private:
  using Corners = std::array<std::uint32_t, 3>;
  struct Level {
    std::uint32_t stride, columns, rows;  // the width in tiles of level 0; of tiles
    bool is_made = false;
    std::vector<float> positions;  // none at level 0, whose triangles are those of the mesh
    std::vector<Corners> triangles;
    std::vector<std::uint32_t> materials;
    std::vector<std::size_t> starts;     // of each tile in `members`, and the end
    std::vector<std::uint32_t> members;  // triangles
  };
  void make(Level& level) const;
  void cluster(Level& level) const;
  void share_out(Level& level, std::size_t triangles) const;
  [[nodiscard]] Triangle corners_of(const Level& level, std::uint32_t triangle) const;
  [[nodiscard]] double width(const Level& level) const { return finest_ * level.stride; }

  const Model& model_;
  const TriangleMesh& mesh_;
  Vec3 low_;           // corner of its bounds, local
  double finest_ = 1;  // the width of a tile of level 0 [m]
  std::mutex making_;
  std::vector<Level> levels_;
};

}  // namespace talus::server
