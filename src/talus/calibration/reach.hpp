#pragma once
// Observations that no set of parameters reaches.

#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

struct Unreached {
  std::string where;  // the group, and the release if they are matched
  std::string what;
  /// No observation of the group is reached, so that its parameters cannot be learned.
  bool is_whole_group = false;
};

/// What lies outside all simulated rocks of all sets. Of releases, three at most for each group.
[[nodiscard]] std::vector<Unreached> unreached(const PreparedStudy& study, const std::vector<SetResult>& sets);

/// Throws BadInput if no observation of a group is reached.
void expect_reach(const PreparedStudy& study, const std::vector<SetResult>& sets);

}  // namespace talus::calibration
