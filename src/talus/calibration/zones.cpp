#include "talus/calibration/zones.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

bool ObservedZone::contains(const Vec2& place) const {
  if (polygons.empty()) return place.x() >= from && place.x() < to;
  return std::ranges::any_of(polygons, [&](const PlanPolygon& polygon) { return polygon.contains(place); });
}

std::size_t ObservedZones::of(const Vec2& place) const {
  const auto found = std::ranges::find_if(list, [&](const ObservedZone& zone) { return zone.contains(place); });
  return static_cast<std::size_t>(found - list.begin());
}

std::string ObservedZones::name_of(std::size_t category) const {
  return category < list.size() ? list[category].name : "elsewhere";
}

std::string ObservedZones::unit() const {
  return amount == ZoneAmount::volume ? "m3" : amount == ZoneAmount::count ? "rocks" : "";
}

double ObservedZones::amount_of(const study::RockEnd& end) const {
  if (amount == ZoneAmount::count) return 1;
  return 4.0 / 3.0 * std::numbers::pi * end.radius * end.radius * end.radius;
}

Sample zone_sample(const ObservedZones& zones, const std::vector<study::RockEnd>& ends) {
  std::vector<std::pair<std::size_t, double>> rocks;
  for (const study::RockEnd& end : ends) {
    // A rock that left the model lies outside all zones, wherever that was.
    const std::size_t category = end.reason == EndReason::left_model ? zones.list.size() : zones.of(end.end.xy());
    if (category < zones.category_count()) rocks.emplace_back(category, zones.amount_of(end));
  }
  Sample sample;
  sample.rows.resize(static_cast<Index>(rocks.size()), 2);
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    sample.rows(static_cast<Index>(k), 0) = static_cast<double>(rocks[k].first);
    sample.rows(static_cast<Index>(k), 1) = rocks[k].second;
  }
  return sample;
}

VectorXd zone_shares(const ObservedZones& zones, const Sample& sample) {
  VectorXd shares = VectorXd::Zero(static_cast<Index>(zones.category_count()));
  for (Index row = 0; row < sample.rows.rows(); ++row)
    shares[static_cast<Index>(sample.rows(row, 0))] += sample.rows(row, 1);
  return shares / shares.sum();
}

double effective_rocks(const Sample& sample) {
  const double sum = sample.rows.col(1).sum();
  return sum * sum / sample.rows.col(1).squaredNorm();
}

double effective_rocks(const ObservedZones& zones, const Sample& observed) {
  const double rocks = effective_rocks(observed);
  const VectorXd shares = zone_shares(zones, observed);
  // Of the amounts a_k = s_k A with independent errors of e a_k, the shares have the covariance J diag(e s)^2 J^T with
  // J = I - s 1^T.
  const Index n = shares.size();
  const MatrixXd jacobian = MatrixXd::Identity(n, n) - shares * Eigen::RowVectorXd::Ones(n);
  const double of_errors = (jacobian * (zones.relative_accuracy * shares).asDiagonal()).squaredNorm();
  const double of_one_rock = 1 - shares.squaredNorm();
  constexpr double nothing = 1e-12;
  if (of_one_rock < nothing) return rocks;
  return of_one_rock / (of_one_rock / rocks + of_errors);
}

}  // namespace talus::calibration
