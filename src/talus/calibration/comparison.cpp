#include "talus/calibration/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

constexpr auto resampling = static_cast<Stream>(1200);

}  // namespace

Comparison::Comparison(const Eigen::MatrixXd& observed, bool in_plane)
    : observed_(observed), in_plane_(in_plane && observed.cols() == 2) {
  for (Eigen::Index f = 0; f < observed.cols(); ++f) {
    const double mean = observed.col(f).mean();
    double spread = std::sqrt((observed.col(f).array() - mean).square().mean());
    if (!(spread > 0)) spread = std::max(std::abs(mean), 1.0);  // a single observation
    scales_.push_back(spread);
  }
  if (in_plane_) {
    // One scale, so that the plane is not distorted.
    const double both = std::hypot(scales_[0], scales_[1]);
    scales_ = {both, both};
    plane_.emplace(points(observed));
    return;
  }
  for (Eigen::Index f = 0; f < observed.cols(); ++f) lines_.emplace_back(line(observed, f));
}

std::vector<Vec2> Comparison::points(const Eigen::MatrixXd& rows) const {
  std::vector<Vec2> points;
  for (Eigen::Index k = 0; k < rows.rows(); ++k) points.emplace_back(rows(k, 0) / scales_[0], rows(k, 1) / scales_[1]);
  return points;
}

std::vector<double> Comparison::line(const Eigen::MatrixXd& rows, Eigen::Index feature) const {
  std::vector<double> values;
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    values.push_back(rows(k, feature) / scales_[static_cast<std::size_t>(feature)]);
  }
  return values;
}

double Comparison::distance(const Eigen::MatrixXd& simulated) const {
  if (in_plane_) return energy_distance(PlaneSample(points(simulated)), *plane_);
  double sum = 0;
  for (std::size_t f = 0; f < lines_.size(); ++f) {
    sum += energy_distance(LineSample(line(simulated, static_cast<Eigen::Index>(f))), lines_[f]);
  }
  return sum / static_cast<double>(lines_.size());
}

double Comparison::score(const Eigen::MatrixXd& simulated, const Eigen::MatrixXd& observations) const {
  double sum = 0;
  if (in_plane_) {
    const PlaneSample sample(points(simulated));
    const std::vector<Vec2> each = points(observations);
    for (const Vec2& one : each) sum += energy_score(sample, one);
    return sum / static_cast<double>(each.size());
  }
  for (std::size_t f = 0; f < lines_.size(); ++f) {
    const LineSample sample(line(simulated, static_cast<Eigen::Index>(f)));
    const std::vector<double> each = line(observations, static_cast<Eigen::Index>(f));
    for (const double one : each) sum += crps(sample, one) / static_cast<double>(each.size() * lines_.size());
  }
  return sum;
}

double Comparison::distance_by_chance(double q, std::uint64_t seed, const std::vector<Eigen::Index>& first_rows) const {
  constexpr int resamples = 400;
  std::vector<double> distances;
  const std::size_t rocks = first_rows.size() - 1;
  for (int k = 0; k < resamples; ++k) {
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < rocks; ++i) {
      const double u = uniform_pair(seed, static_cast<std::uint64_t>(k), resampling, static_cast<std::uint32_t>(i))[0];
      const std::size_t rock = std::min(static_cast<std::size_t>(u * static_cast<double>(rocks)), rocks - 1);
      for (Eigen::Index row = first_rows[rock]; row < first_rows[rock + 1]; ++row) rows.push_back(row);
    }
    distances.push_back(distance(observed_(rows, Eigen::seq(0, observed_.cols() - 1))));
  }
  std::sort(distances.begin(), distances.end());
  return distances[static_cast<std::size_t>(q * (resamples - 1))];
}

OwnScores Comparison::own_scores(const Eigen::MatrixXd& simulated) const {
  const auto n = static_cast<double>(simulated.rows());
  std::vector<double> scores(static_cast<std::size_t>(simulated.rows()), 0);
  double spread = 0;
  if (in_plane_) {
    const PlaneSample sample(points(simulated));
    for (std::size_t k = 0; k < scores.size(); ++k) scores[k] = energy_score(sample, sample.points()[k]);
    spread = sample.spread();
  } else {
    for (std::size_t f = 0; f < lines_.size(); ++f) {
      const std::vector<double> values = line(simulated, static_cast<Eigen::Index>(f));
      const LineSample sample(values);
      for (std::size_t k = 0; k < scores.size(); ++k)
        scores[k] += crps(sample, values[k]) / static_cast<double>(lines_.size());
      spread += sample.spread() / static_cast<double>(lines_.size());
    }
  }
  OwnScores own;
  for (const double score : scores) own.mean += score / n;
  for (const double score : scores) own.variance += (score - own.mean) * (score - own.mean) / (n - 1);
  // A rock of the sample is nearer to it, by itself, than another rock would be.
  own.mean += spread / (n - 1);
  return own;
}

}  // namespace talus::calibration
