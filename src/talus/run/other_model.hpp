#pragma once
// Whether the other rock model agrees: lumped mass and rigid sphere are two idealisations of the same block, and
// results that hold for one alone should not be trusted without a reason. A fair sample of the rocks is simulated with
// both, with the same releases and draws, before the run.
//
// Compared are the 95th percentiles of the runout on plan and of the highest place of the block's top over the ground.
// They disagree if they differ by more than a factor of two and their intervals are apart. The sample is a twentieth of
// the rocks, at most 200, so that both take about a tenth of the time of the run; of fewer than 72 a 95th percentile
// has no upper end, and nothing is compared. Nor is it if a material has the default friction of the other model, which
// nobody has chosen; or with ensembles. Checked by test/run/other_model_test.cpp.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus::project {

struct ModelFigures {
  Estimate runout, top;  // 95th percentiles with their 95 % intervals [m]
};

struct ModelComparison {
  std::uint64_t rocks = 0;  // of the sample
  RockModel other = RockModel::lumped_mass;
  ModelFigures own, by_other;
};

/// Whether two estimates differ by more than a factor of two, and their intervals are apart.
[[nodiscard]] bool disagree(const Estimate& one, const Estimate& other);

/// One rock of each of `sample` stretches of as many rocks, by the seed alone; ascending.
[[nodiscard]] std::vector<std::uint64_t> fair_sample(std::uint64_t rocks, std::uint64_t sample, std::uint64_t seed);

/// Nullopt if they are not compared. Throws Stopped at the request of the thread's StopScope.
[[nodiscard]] std::optional<ModelComparison> compare_models(const Project& project, const Model& model, int threads);

/// Warns of each quantity about which they disagree.
void warn_of_other_model(const ModelComparison& found, Problems& warnings);

}  // namespace talus::project
