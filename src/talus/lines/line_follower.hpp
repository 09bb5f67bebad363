#pragma once
// Follows rocks, one after the other, past the barriers of a model and the lines that are asked.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talus/barriers/plan_index.hpp"
#include "talus/campaign/model.hpp"
#include "talus/campaign/own_section.hpp"
#include "talus/lines/asked_line.hpp"
#include "talus/lines/path_crossings.hpp"
#include "talus/lines/rock_paths.hpp"
#include "talus/project/project.hpp"
#include "talus/results/design_plan.hpp"

namespace talus {

/// The model's barriers, and the lines that are asked.
struct AskedBarriers {
  std::vector<Barrier> all;
  std::vector<std::uint32_t> numbers;  // of the lines
  PlanIndex on_plan;

  AskedBarriers(const Model& model, std::span<const AskedLine> lines);
};

/// Each thread needs its own.
class LineFollower {
 public:
  /// `model` and `barriers` must outlive it.
  LineFollower(const Model& model, const AskedBarriers& barriers);
  /// The crossings of the rock of `path`.
  [[nodiscard]] const RockLog& follow(const RockPath& path);

 private:
  const Model& model_;
  const AskedBarriers& asked_;
  std::unique_ptr<OwnSection> section_;
  PathCrossings crossings_;
};

}  // namespace talus
