#include "talus/import/filler_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace talus {

namespace {

// Limits of the types of numbers, rows of nines, and the defaults of programs for meshes and climate data.
// clang-format off
constexpr std::array fillers{
    -1.7976931348623157e308, -3.4028234663852886e38, -1e38, -1e37, -1e32, -1e30, -1e20, -1e10, -2147483648.0,
    -2147483647.0, -9999999.0, -999999.0, -99999.0, -32768.0, -32767.0, -10000.0, -9999.99, -9999.9, -9999.0,
    -8888.0, -5000.0, -1000.0, -999.99, -999.9, -999.25, -999.0, -888.0, -500.0, -128.0, -100.0, -99.99, -99.9,
    -99.0, -88.0, -9.0, -1.0, 9.0, 99.0, 99.9, 99.99, 127.0, 255.0, 888.0, 999.0, 999.9, 999.99, 8888.0, 9999.0,
    9999.9, 9999.99, 10000.0, 32766.0, 32767.0, 65534.0, 65535.0, 65536.0, 99999.0, 100000.0, 999999.0,
    9999999.0, 2147483647.0, 2147483648.0, 4294967295.0, 1e10, 1e20, 1e30, 1e32, 1e37, 1e38,
    3.4028234663852886e38, 1.7976931348623157e308};
// clang-format on
static_assert(std::ranges::is_sorted(fillers));

// How far a height must be from the others: more than the ground's steps, and more than a cliff at the end of a line.
constexpr double much_m = 10, very_much_m = 100;

/// The vertices from `from` to `to`, which have the same height.
struct Run {
  std::size_t from, to;
};

Run run_around(std::span<const Vec3> line, std::size_t k) {
  Run run{k, k};
  while (run.from > 0 && line[run.from - 1].z() == line[k].z()) --run.from;
  while (run.to + 1 < line.size() && line[run.to + 1].z() == line[k].z()) ++run.to;
  return run;
}

/// Whether the line is steep on each side that a run has.
bool is_steep_beside(std::span<const Vec3> line, const Run& run) {
  constexpr double steep = 2;  // height over length on plan
  const auto is_steep = [&](std::size_t a, std::size_t b) {
    return std::abs(line[a].z() - line[b].z()) > steep * (line[a] - line[b]).xy().norm();
  };
  return (run.from == 0 || is_steep(run.from - 1, run.from)) &&
         (run.to + 1 == line.size() || is_steep(run.to, run.to + 1));
}

}  // namespace

std::span<const double> filler_values() { return fillers; }

bool may_be_filler(double value) {
  // As such, or rounded to 32 bits.
  const auto is_same = [&](double filler) {
    constexpr double largest = std::numeric_limits<float>::max();
    return filler == value || (std::abs(filler) <= largest && double{static_cast<float>(filler)} == value);
  };
  const auto next = std::ranges::lower_bound(fillers, value);
  return value == 0 || (next != fillers.end() && is_same(*next)) || (next != fillers.begin() && is_same(*(next - 1)));
}

bool is_far_from(double height, double low, double high) {
  return std::max(low - height, height - high) > std::max(high - low, much_m);
}

std::vector<DoubtfulHeight> doubtful_heights(std::span<const Vec3> points) {
  std::map<double, DoubtfulHeight> fillers;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double z = points[k].z();
    if (may_be_filler(z)) {
      DoubtfulHeight& filler = fillers[z];
      if (++filler.count == 1) filler.first = k;
    } else {
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  std::vector<DoubtfulHeight> doubtful;
  for (auto& [height, filler] : fillers) {
    if (low > high || !is_far_from(height, low, high)) continue;
    filler.height = height, filler.low = low, filler.high = high;
    doubtful.push_back(filler);
  }
  return doubtful;
}

std::optional<std::size_t> vertex_without_height(std::span<const Vec3> line) {
  // The heights that are furthest down and up: one of them is alone, or the line is an ordinary one.
  const auto by_height = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
  const auto [lowest, highest] = std::ranges::minmax_element(line, by_height);
  for (const auto extreme : {lowest, highest}) {
    const double z = extreme->z();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::size_t others = 0;
    for (const Vec3& p : line) {
      if (p.z() == z) continue;
      ++others;
      low = std::min(low, p.z());
      high = std::max(high, p.z());
    }
    const std::size_t same = line.size() - others;
    const double apart = z < low ? low - z : z - high;
    const bool are_few = 3 * same <= others || (same < others && apart > very_much_m);
    if (!are_few || !is_far_from(z, low, high)) continue;
    const Run run = run_around(line, static_cast<std::size_t>(extreme - line.begin()));
    const bool is_level = high == low, is_within = run.from > 0 && run.to + 1 < line.size();
    const bool is_steep = is_steep_beside(line, run);
    const bool is_missing = is_within ? (may_be_filler(z) ? is_level || is_steep : is_level && is_steep && same == 1)
                                      : may_be_filler(z) && (is_level || is_steep) && (z != 0 || apart > very_much_m);
    if (is_missing) return run.from;
  }
  return std::nullopt;
}

}  // namespace talus
