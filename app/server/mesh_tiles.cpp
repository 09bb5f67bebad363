#include "mesh_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>

#include "http/arrays.hpp"
#include "model_description.hpp"

namespace talus::server {

namespace {

std::uint32_t count_of(double length, double width) {
  return std::max(1U, static_cast<std::uint32_t>(std::ceil(length / width)));
}

struct HashOfCube {
  std::size_t operator()(const std::array<std::int32_t, 3>& cube) const {
    std::size_t hash = 0;
    for (const std::int32_t k : cube) hash = (hash ^ static_cast<std::uint32_t>(k)) * 0x9e3779b97f4a7c15U;
    return hash ^ (hash >> 29);
  }
};

/// Numbers things in the order in which they come.
template <class Thing, class Hash = std::hash<Thing>>
class Numbers {
 public:
  /// The number of a thing, and whether it is new.
  std::pair<std::uint32_t, bool> of(const Thing& thing) {
    const auto [found, is_new] = known_.try_emplace(thing, static_cast<std::uint32_t>(known_.size()));
    return {found->second, is_new};
  }

 private:
  std::unordered_map<Thing, std::uint32_t, Hash> known_;
};

}  // namespace

MeshTiles::MeshTiles(const Model& model, const TriangleMesh& mesh)
    : model_(model), mesh_(mesh), low_(mesh.bounds().low) {
  const Vec3 extent = mesh.bounds().high - low_;
  const double tiles = std::max(1.0, static_cast<double>(mesh.facet_count()) / triangles_of_finest_tile);
  // At most four times as many tiles along a narrow mesh as in a square.
  finest_ =
      std::max({std::sqrt(extent.x() * extent.y() / tiles), extent.x() / (4 * tiles), extent.y() / (4 * tiles), 1e-3});
  for (std::uint32_t stride = 1;; stride *= 2) {
    levels_.push_back({stride, count_of(extent.x(), finest_ * stride), count_of(extent.y(), finest_ * stride)});
    if (levels_.back().columns == 1 && levels_.back().rows == 1) return;
  }
}

Json MeshTiles::description() const {
  Json levels = Json::array();
  for (const Level& level : levels_)
    levels.push_back({{"stride", level.stride}, {"columns", level.columns}, {"rows", level.rows}});
  const double cell = finest_ / side;
  return {{"origin", as_json(model_.frame.global_from_local(low_))},
          {"cell", {cell, cell}},
          {"columns", levels_.front().columns * side + 1},
          {"rows", levels_.front().rows * side + 1},
          {"tile", side},
          {"levels", std::move(levels)}};
}

Triangle MeshTiles::corners_of(const Level& level, std::uint32_t triangle) const {
  if (level.stride == 1) return mesh_.triangle({triangle});
  const auto corner = [&](std::uint32_t vertex) {
    const float* p = &level.positions[3 * std::size_t{vertex}];
    return Vec3(p[0], p[1], p[2]);
  };
  const auto& [a, b, c] = level.triangles[triangle];
  return {corner(a), corner(b), corner(c)};
}

void MeshTiles::cluster(Level& level) const {
  const double cube = width(level) / side;
  Numbers<std::array<std::int32_t, 3>, HashOfCube> cubes;
  std::vector<std::array<double, 4>> sums;  // of places, and how many
  Numbers<std::array<std::int32_t, 3>, HashOfCube> known;
  std::vector<std::uint32_t> facets;  // from which the triangles come
  for (std::uint32_t k = 0; k < mesh_.facet_count(); ++k) {
    Corners corners{};
    std::size_t at = 0;
    for (const Vec3& corner : mesh_.triangle({k})) {
      const Vec3 place = (corner - low_) / cube;
      const auto [number, is_new] =
          cubes.of({static_cast<std::int32_t>(place.x()), static_cast<std::int32_t>(place.y()),
                    static_cast<std::int32_t>(place.z())});
      if (is_new) sums.push_back({});
      for (int axis = 0; axis < 3; ++axis) sums[number][static_cast<std::size_t>(axis)] += corner[axis];
      sums[number][3] += 1;
      corners[at++] = number;
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    Corners sorted = corners;
    std::ranges::sort(sorted);
    const bool is_new = known
                            .of({static_cast<std::int32_t>(sorted[0]), static_cast<std::int32_t>(sorted[1]),
                                 static_cast<std::int32_t>(sorted[2])})
                            .second;
    if (!is_new) continue;
    level.triangles.push_back(corners);
    facets.push_back(k);
  }
  for (const auto& [x, y, z, count] : sums)
    for (const double sum : {x, y, z}) level.positions.push_back(static_cast<float>(sum / count));
  // Some triangles are turned over, which would be seen as specks; without them there would be holes.
  std::size_t kept = 0;
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    const double along = area_normal(corners_of(level, k)).dot(area_normal(mesh_.triangle({facets[k]})));
    if (along == 0) continue;
    Corners corners = level.triangles[k];
    if (along < 0) std::swap(corners[1], corners[2]);
    level.triangles[kept++] = corners;
    level.materials.push_back(model_.ground.material_of(mesh_.source({facets[k]})).index);
  }
  level.triangles.resize(kept);
}

void MeshTiles::share_out(Level& level, std::size_t triangles) const {
  const double tile = width(level), close = tile / side;
  const auto each = [&](auto&& visit) {
    const auto within = [&](double place, std::uint32_t count) {
      return static_cast<std::uint32_t>(std::clamp(std::floor(place / tile), 0.0, count - 1.0));
    };
    for (std::uint32_t k = 0; k < triangles; ++k) {
      const auto [a, b, c] = corners_of(level, k);
      const Vec3 low = a.min(b).min(c) - low_, high = a.max(b).max(c) - low_;
      const std::uint32_t last_column = within(high.x() + close, level.columns);
      const std::uint32_t last_row = within(high.y() + close, level.rows);
      for (std::uint32_t row = within(low.y() - close, level.rows); row <= last_row; ++row)
        for (std::uint32_t column = within(low.x() - close, level.columns); column <= last_column; ++column)
          visit(std::size_t{row} * level.columns + column, k);
    }
  };
  level.starts.assign(std::size_t{level.columns} * level.rows + 1, 0);
  each([&](std::size_t place, std::uint32_t) { ++level.starts[place + 1]; });
  for (std::size_t k = 1; k < level.starts.size(); ++k) level.starts[k] += level.starts[k - 1];
  level.members.resize(level.starts.back());
  std::vector<std::size_t> next = level.starts;
  each([&](std::size_t place, std::uint32_t triangle) { level.members[next[place]++] = triangle; });
}

void MeshTiles::make(Level& level) const {
  if (level.stride > 1) cluster(level);
  share_out(level, level.stride > 1 ? level.triangles.size() : mesh_.facet_count());
  level.is_made = true;
}

Answer MeshTiles::tile(std::size_t number, std::uint32_t column, std::uint32_t row) {
  if (number >= levels_.size() || column >= levels_[number].columns || row >= levels_[number].rows)
    throw Refusal(404, fmt::format("tile {}/{}/{}", number, column, row), "there is no such tile");
  Level& level = levels_[number];
  {
    const std::lock_guard one_at_a_time(making_);
    if (!level.is_made) make(level);
  }
  const std::size_t place = std::size_t{row} * level.columns + column;
  const auto members =
      std::span(level.members).subspan(level.starts[place], level.starts[place + 1] - level.starts[place]);
  Numbers<std::array<std::int32_t, 3>, HashOfCube> vertices;
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles, materials;
  const bool is_whole = number == 0;
  for (const std::uint32_t member : members) {
    for (const Vec3& corner : corners_of(level, member)) {
      const std::array single{static_cast<float>(corner.x()), static_cast<float>(corner.y()),
                              static_cast<float>(corner.z())};
      const auto [vertex, is_new] = vertices.of(std::bit_cast<std::array<std::int32_t, 3>>(single));
      if (is_new) positions.insert(positions.end(), single.begin(), single.end());
      triangles.push_back(vertex);
    }
    materials.push_back(is_whole ? model_.ground.material_of(mesh_.source({member})).index : level.materials[member]);
  }
  Arrays arrays(Json{{"origin", as_json(model_.frame.origin)}});
  arrays.add("positions", std::span<const float>(positions));
  arrays.add("triangles", std::span<const std::uint32_t>(triangles));
  arrays.add_smallest("materials", materials, model_.ground.materials().size());
  if (is_whole) arrays.add("facets", std::span<const std::uint32_t>(members));
  return arrays.answer();
}

}  // namespace talus::server
