#include "talus/meshing/weld.hpp"

#include <tbb/parallel_sort.h>

#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "talus/core/check.hpp"

namespace talus {
namespace {

std::vector<std::uint32_t> identity(std::size_t count) {
  std::vector<std::uint32_t> out(count);
  for (std::uint32_t i = 0; i < count; ++i) out[i] = i;
  return out;
}

std::vector<std::uint32_t> welded_exactly(const std::vector<Vec3>& vertices) {
  struct Place {
    double x, y, z;
    std::uint32_t vertex;
    bool operator<(const Place& o) const {
      if (x != o.x) return x < o.x;
      if (y != o.y) return y < o.y;
      if (z != o.z) return z < o.z;
      return vertex < o.vertex;
    }
    [[nodiscard]] bool same_place(const Place& o) const { return x == o.x && y == o.y && z == o.z; }
  };
  std::vector<Place> places;
  places.reserve(vertices.size());
  for (const Vec3& v : vertices) places.push_back({v.x(), v.y(), v.z(), static_cast<std::uint32_t>(places.size())});
  tbb::parallel_sort(places);
  std::vector<std::uint32_t> out = identity(vertices.size());
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].same_place(places[i - 1])) out[places[i].vertex] = out[places[i - 1].vertex];
  }
  return out;
}

// Kept vertices in cubes a few tolerances wide, so that a ball with the tolerance as radius mostly touches one or two
// of them. A cube has a bounded number of vertices, since kept ones are further apart than the tolerance.
class Cubes {
 public:
  explicit Cubes(double tolerance) : tolerance_(tolerance), width_(4 * tolerance) {}

  [[nodiscard]] std::optional<std::uint32_t> nearest(const std::vector<Vec3>& vertices, const Vec3& place) const {
    std::optional<std::uint32_t> best;
    double best_distance = tolerance_ * tolerance_;
    const Cube low = cube_of(place - Vec3::all(tolerance_));
    const Cube high = cube_of(place + Vec3::all(tolerance_));
    for (int corner = 0; corner < 8; ++corner) {
      Cube cube = low;
      bool is_new = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1) == 0) continue;
        is_new = is_new && high[axis] != low[axis];
        cube[axis] = high[axis];
      }
      const auto found = is_new ? cubes_.find(cube) : cubes_.end();
      if (found == cubes_.end()) continue;
      for (const std::uint32_t vertex : found->second) {
        const double distance = (vertices[vertex] - place).squared_norm();
        if (distance < best_distance || (distance == best_distance && (!best || vertex < *best))) {
          best = vertex;
          best_distance = distance;
        }
      }
    }
    return best;
  }

  void keep(std::uint32_t vertex, const Vec3& place) { cubes_[cube_of(place)].push_back(vertex); }

 private:
  using Cube = std::array<double, 3>;  // integers that may exceed an integer type if the tolerance is tiny

  [[nodiscard]] Cube cube_of(const Vec3& place) const {
    return {std::floor(place.x() / width_), std::floor(place.y() / width_), std::floor(place.z() / width_)};
  }

  double tolerance_;
  double width_;
  std::unordered_map<Cube, std::vector<std::uint32_t>, boost::hash<Cube>> cubes_;
};

}  // namespace

std::vector<std::uint32_t> welded(const std::vector<Vec3>& vertices, double tolerance_m) {
  TALUS_PROMISE(tolerance_m >= 0, "a tolerance is not negative");
  std::vector<std::uint32_t> out = welded_exactly(vertices);
  if (tolerance_m == 0) return out;
  Cubes cubes{tolerance_m};
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    if (out[i] != i) {
      out[i] = out[out[i]];  // the first vertex at its place came earlier and may have been merged itself
    } else if (const auto representative = cubes.nearest(vertices, vertices[i])) {
      out[i] = *representative;
    } else {
      cubes.keep(i, vertices[i]);
    }
  }
  return out;
}

}  // namespace talus
