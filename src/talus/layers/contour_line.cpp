#include "talus/layers/contour_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "talus/core/stop.hpp"
#include "talus/layers/layer_shapes.hpp"

namespace talus {

namespace {

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

/// Its ends in a fixed order: neighbours share corners bit for bit, and so find the same edge and the same crossing.
struct ContourEdge {
  std::array<double, 6> ends;

  ContourEdge(const Vec3& a, const Vec3& b) {
    const bool in_order = coordinates(a) < coordinates(b);
    const Vec3 &first = in_order ? a : b, &second = in_order ? b : a;
    ends = {first.x(), first.y(), first.z(), second.x(), second.y(), second.z()};
  }
  bool operator==(const ContourEdge&) const = default;

  [[nodiscard]] Vec2 at(double z) const {
    const double share = (z - ends[2]) / (ends[5] - ends[2]);
    return {std::lerp(ends[0], ends[3], share), std::lerp(ends[1], ends[4], share)};
  }
};

struct HashOfEdge {
  std::size_t operator()(const ContourEdge& edge) const {
    return std::hash<std::string_view>{}(
        {reinterpret_cast<const char*>(edge.ends.data()), edge.ends.size() * sizeof(double)});
  }
};

/// All contours of one elevation as crossings of edges, each linked to those on the two triangles of its edge. A corner
/// at this very elevation counts as above it, so that every triangle is crossed on two edges or on none.
class Crossings {
 public:
  explicit Crossings(double z) : z_(z) {}

  void add(const Triangle& corners) {
    std::array<std::uint32_t, 2> crossed{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = corners[k], &b = corners[(k + 1) % 3];
      if ((a.z() >= z_) != (b.z() >= z_)) crossed[count++] = number_of(ContourEdge(a, b));
    }
    if (count < 2) return;
    link(crossed[0], crossed[1]);
    link(crossed[1], crossed[0]);
  }

  [[nodiscard]] std::vector<Vec2> line_near(const Vec2& place) const {
    if (points_.empty()) return {};
    const auto nearest = std::ranges::min_element(
        points_, {}, [&](const Crossing& crossing) { return (crossing.place - place).squared_norm(); });
    const auto start = static_cast<std::uint32_t>(nearest - points_.begin());
    std::vector<Vec2> line = walk(start, nearest->next[0]);
    std::ranges::reverse(line);
    line.push_back(nearest->place);
    const bool is_closed = line.size() > 2 && line.front() == nearest->place;
    if (is_closed) return line;
    const std::vector<Vec2> rest = walk(start, nearest->next[1]);
    line.insert(line.end(), rest.begin(), rest.end());
    return line;
  }

 private:
  struct Crossing {
    Vec2 place;
    std::array<std::uint32_t, 2> next{nothing, nothing};
  };

  std::uint32_t number_of(const ContourEdge& edge) {
    const auto [at, is_new] = numbers_.emplace(edge, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back({edge.at(z_)});
    return at->second;
  }

  void link(std::uint32_t from, std::uint32_t to) {
    auto& next = points_[from].next;
    (next[0] == nothing ? next[0] : next[1]) = to;
  }

  /// The places after `start`, in the direction of `at`, up to the border or back to the start.
  [[nodiscard]] std::vector<Vec2> walk(std::uint32_t start, std::uint32_t at) const {
    std::vector<Vec2> line;
    for (std::uint32_t before = start; at != nothing; stop_point(line.size())) {
      line.push_back(points_[at].place);
      if (at == start || line.size() > points_.size()) break;
      const auto& next = points_[at].next;
      const std::uint32_t onward = next[0] == before ? next[1] : next[0];
      before = at;
      at = onward;
    }
    return line;
  }

  double z_;
  std::vector<Crossing> points_;
  std::unordered_map<ContourEdge, std::uint32_t, HashOfEdge> numbers_;
};

void add_all(const TriangleMesh& mesh, double, Crossings& crossings) {
  for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) {
    stop_point(k);
    crossings.add(mesh.triangle({k}));
  }
}

void add_all(const RasterSurface& raster, double z, Crossings& crossings) {
  const RasterGrid& grid = raster.grid();
  for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
    stop_point();
    for (std::uint32_t column = 0; column + 1 < grid.columns; ++column) {
      const float* const south = grid.z.data() + grid.index(column, row);
      const float* const north = south + grid.columns;
      // A comparison with a cell without data is false: it counts as below, and is looked at more closely.
      const int above = (south[0] >= z) + (south[1] >= z) + (north[0] >= z) + (north[1] >= z);
      if (above == 0 || above == 4 || !raster.has_data(column, row)) continue;
      const std::uint32_t cell = row * (grid.columns - 1) + column;
      crossings.add(raster.triangle({2 * cell}));
      crossings.add(raster.triangle({2 * cell + 1}));
    }
  }
}

void add_all(const Profile&, double, Crossings&) {}

}  // namespace

std::optional<ContourLine> contour_through(const Model& model, const Vec2& place, std::optional<double> elevation,
                                           std::size_t most) {
  const Vec2 local = place - model.frame.origin.xy();
  return std::visit(
      [&](const auto& surface) -> std::optional<ContourLine> {
        const std::optional<double> here = surface.elevation(local.x(), local.y());
        if (!here) return std::nullopt;
        const double z = elevation ? *elevation - model.frame.origin.z() : *here;
        Crossings crossings(z);
        add_all(surface, z, crossings);
        std::vector<Vec2> line = simplified_to(crossings.line_near(local), most);
        if (line.size() < 2) return std::nullopt;
        for (Vec2& p : line) p += model.frame.origin.xy();
        return ContourLine{z + model.frame.origin.z(), std::move(line)};
      },
      *model.surface);
}

}  // namespace talus
