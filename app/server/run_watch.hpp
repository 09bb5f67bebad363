#pragma once
// What a run has found so far, for a page that watches it: counts of all rocks, and some of their trajectories.

#include <array>
#include <cstdint>
#include <mutex>
#include <vector>

#include "results/drawn_paths.hpp"
#include "talus/archive/even_choice.hpp"
#include "talus/archive/result_tables.hpp"
#include "talus/campaign/model.hpp"
#include "talus/results/record.hpp"
#include "talus/results/summary.hpp"

namespace talus::server {

/// The counts of a Summary.
struct CountsSoFar {
  std::uint64_t done = 0, planned = 0;
  std::array<std::uint64_t, end_reason_count> ends{};
  std::vector<std::uint64_t> rocks_hit;  // by barrier and collector
};

/// Observes a run, and can be asked meanwhile. Keeps the trajectories of at most `most_paths` rocks, evenly chosen from
/// all rocks of the run, so that its memory and time do not grow with the run. The model must outlive the observation,
/// but not the answers.
class RunWatch : public Observer {
 public:
  static constexpr std::uint64_t most_paths = 1000;

  explicit RunWatch(const Model& model);

  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override { return chosen_.contains(rock); }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void take(const Summary& summary);

  [[nodiscard]] CountsSoFar counts() const;
  /// The trajectories so far, those of the rocks with the lowest numbers. `rocks.total`: of how many rocks they are a
  /// choice.
  [[nodiscard]] DrawnPaths paths() const;

 private:
  struct Part;

  const Model& model_;
  const TableContext context_;
  const EvenChoice chosen_;
  mutable std::mutex mutex_;  // guards what follows
  CountsSoFar counts_;
  DrawnPaths paths_;
};

}  // namespace talus::server
