#pragma once
// Distances between simulated and observed distributions of one group.

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "talus/core/vec.hpp"
#include "talus/statistics/proper_scores.hpp"

namespace talus::calibration {

/// The energy score of a rock in the distribution that it was drawn from.
struct OwnScores {
  double mean = 0, variance = 0;
};

/// Compares samples with observations by proper scores, over the observed spread of each feature: the energy distance
/// and the energy score in the plane for stops in 3D, and the mean over features of the same on a line otherwise.
class Comparison {
 public:
  /// Expects one row or more.
  Comparison(const Eigen::MatrixXd& observed, bool in_plane);

  /// Energy distance from the observed distribution; 0: the same.
  [[nodiscard]] double distance(const Eigen::MatrixXd& simulated) const;
  /// Mean energy score of these observations in the forecast `simulated`, over the same spread.
  [[nodiscard]] double score(const Eigen::MatrixXd& simulated, const Eigen::MatrixXd& observations) const;
  /// The distance that a share `q` of resamples of the observed rocks, of as many rocks, have at most. `first_rows`: of
  /// each rock, and the number of rows.
  [[nodiscard]] double distance_by_chance(double q, std::uint64_t seed,
                                          const std::vector<Eigen::Index>& first_rows) const;
  /// Of rocks of the same distribution. Expects two rows or more.
  [[nodiscard]] OwnScores own_scores(const Eigen::MatrixXd& simulated) const;

 private:
  [[nodiscard]] std::vector<Vec2> points(const Eigen::MatrixXd& rows) const;
  [[nodiscard]] std::vector<double> line(const Eigen::MatrixXd& rows, Eigen::Index feature) const;

  Eigen::MatrixXd observed_;
  bool in_plane_;
  std::vector<double> scales_;  // of each feature
  std::optional<PlaneSample> plane_;
  std::vector<LineSample> lines_;
};

}  // namespace talus::calibration
