#pragma once
// Draws of simulated rocks that are observed as the real ones were: as many rocks, each from its own release, and as
// many marks of each rock.
//
// Where several rows are of one rock, whole rocks are drawn (the cluster bootstrap: C. A. Field and A. H. Welsh,
// "Bootstrapping clustered data", Journal of the Royal Statistical Society B 69 (2007) 369-390), since the impacts of
// one trajectory are not independent of each other.

#include <cstdint>
#include <vector>

#include <Eigen/Dense>

namespace talus::calibration {

/// Rows by features.
struct Sample {
  Eigen::MatrixXd rows;
  std::vector<std::uint32_t> strata{};  // of each row: its release; empty: all the same
  std::vector<std::uint32_t> rocks{};   // of each row: its rock; rows of one follow each other; empty: all different

  [[nodiscard]] bool has_strata() const { return !strata.empty(); }
  /// These rows, in this order.
  [[nodiscard]] Sample part(const std::vector<Eigen::Index>& which) const;
  /// The rows of a stratum.
  [[nodiscard]] Sample stratum(std::uint32_t number) const;
  /// The first row of each rock, and the number of rows at the end.
  [[nodiscard]] std::vector<Eigen::Index> first_rows() const;
  /// One more than the largest number of a stratum; 1 without strata.
  [[nodiscard]] std::uint32_t stratum_count() const;
};

class Redraw {
 public:
  /// `like`: the observed rocks. Both must outlive this.
  Redraw(const Sample& simulated, const Sample& like);
  /// Whether every observed rock has at least this many simulated ones of its release.
  [[nodiscard]] bool has_at_least(std::size_t rocks) const;
  /// The numbers of simulated rocks and of observed ones.
  [[nodiscard]] std::size_t simulated_rocks() const { return first_rows_.size() - 1; }
  [[nodiscard]] std::size_t observed_rocks() const { return observed_.size(); }
  /// The simulated rows of one replica, drawn with replacement by rock; the marks of a rock without replacement, all of
  /// them if it has fewer than were observed. The same seed draws the same numbers for every sample.
  void rows(std::uint64_t seed, std::uint32_t replica, std::vector<Eigen::Index>& rows) const;

 private:
  struct ObservedRock {
    std::uint32_t stratum = 0;
    Eigen::Index rows = 1;
  };
  std::vector<ObservedRock> observed_;
  std::vector<Eigen::Index> first_rows_;              // of the simulated rocks
  std::vector<std::vector<std::size_t>> of_stratum_;  // simulated rocks
};

}  // namespace talus::calibration
