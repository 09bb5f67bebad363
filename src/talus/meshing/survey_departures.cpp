#include "talus/meshing/survey_departures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

// A point is an outlier if it departs by at least least_m, and this many times as far as its neighbours do: at the edge
// of a cliff the neighbours depart as well.
constexpr double outlier_ratio = 10;
constexpr double least_m = 1;

std::vector<std::optional<Departure>> departures(const Triangulation& t, const SurveyPlaces& places) {
  std::vector<std::optional<Departure>> out(places.at.size());
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(out.size()), 4096),
                    [&](const auto& range) {
                      for (std::uint32_t v = range.begin(); v < range.end(); ++v) {
                        if (!places.is_on_line[v]) out[v] = departure(t, places.height, v);
                      }
                    });
  return out;
}

}  // namespace

std::optional<Departure> departure(const Triangulation& t, const std::vector<double>& heights,
                                   Triangulation::Vertex vertex) {
  const GridPoint at = t.point(vertex);
  const auto first = t.side_from(vertex);
  const double base = heights[vertex];  // subtracted, so that large elevations lose no digits
  const auto each_neighbour = [&](auto&& take) {
    auto side = first;
    do {
      const auto neighbour = t.to(side);
      if (neighbour == Triangulation::infinity) return false;
      const GridPoint to = t.point(neighbour);
      const Vec3 row(double{1} * to.x - at.x, double{1} * to.y - at.y, 1);
      take(row, 1 / row.xy().squared_norm(), heights[neighbour] - base);
      side = t.next_around(side);
    } while (side.triangle != first.triangle);
    return true;
  };

  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double count = 0, weights = 0;
  const bool is_within = each_neighbour([&](const Vec3& row, double weight, double height) {
    const Eigen::Vector3d terms(row.x(), row.y(), row.z());
    squares += weight * terms * terms.transpose();
    right += weight * height * terms;
    weights += weight;
    ++count;
  });
  if (!is_within) return std::nullopt;
  const Eigen::Vector3d solution = squares.ldlt().solve(right);  // neighbours on all sides span a plane
  const Vec3 plane(solution.x(), solution.y(), solution.z());
  if (count < 4) return Departure{-plane.z(), std::numeric_limits<double>::infinity()};
  double sum = 0;
  each_neighbour([&](const Vec3& row, double weight, double height) {
    const double residual = height - plane.dot(row);
    sum += weight * residual * residual;
  });
  return Departure{-plane.z(), std::sqrt(sum / weights * count / (count - 3))};
}

std::vector<std::uint32_t> spikes(const Triangulation& t, const SurveyPlaces& places, double limit_m) {
  const auto all = departures(t, places);
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < all.size(); ++v) {
    if (!all[v] || std::abs(all[v]->height_m) <= limit_m) continue;
    bool is_largest = true;
    const auto first = t.side_from(v);
    auto side = first;
    do {
      const auto& other = all[t.to(side)];
      is_largest = is_largest && (!other || std::abs(other->height_m) <= std::abs(all[v]->height_m));
      side = t.next_around(side);
    } while (side.triangle != first.triangle);
    if (is_largest) out.push_back(v);
  }
  return out;
}

void report_departures(const Triangulation& t, const SurveyPlaces& places, SurveyReport& report) {
  const auto all = departures(t, places);
  std::vector<double> sizes;
  for (std::uint32_t v = 0; v < all.size(); ++v) {
    if (!all[v]) continue;
    sizes.push_back(std::abs(all[v]->height_m));
    if (sizes.back() > std::max(least_m, outlier_ratio * all[v]->spread_m)) report.outliers.add(places.place(v));
    if (sizes.back() <= report.largest_departure_m) continue;
    report.largest_departure_m = sizes.back();
    report.largest_departure_at = places.place(v);
  }
  report.interior_points = sizes.size();
  if (sizes.empty()) return;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  report.median_departure_m = *middle;
}

}  // namespace talus
