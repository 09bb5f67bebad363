#pragma once
// One rock of a campaign by its number: a pure function of (model, number). Replay and campaign share it.

#include "talus/campaign/model.hpp"
#include "talus/results/record.hpp"

namespace talus {

/// Simulates rocks of one model, one at a time; each thread has its own.
class Simulator {
 public:
  explicit Simulator(const Model& model);
  /// Rows and pieces of the path are kept only if asked for; the log is good until the next rock.
  RockRecord simulate(std::uint64_t rock, bool keep_rows, bool keep_pieces = false);
  [[nodiscard]] const RockLog& log() const { return log_; }

 private:
  template <class Surface>
  RockRecord simulate_on(const Surface& surface, std::uint64_t rock);

  const Model& model_;
  RockLog log_{false};
  std::optional<Profile> own_profile_;  // where the section varies from rock to rock
  std::vector<Vec2> own_vertices_;
};

}  // namespace talus
