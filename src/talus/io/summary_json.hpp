#pragma once
// summary.json: what a run was and how it came out.

#include <nlohmann/json.hpp>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/model.hpp"
#include "talus/results/summary.hpp"

namespace talus {

struct RunDescription {
  std::string name;
  nlohmann::ordered_json project;  // echoed whole, defaults filled in
  std::vector<std::string> warnings;
};

/// Everything but `timings` depends on the project, the seed and the rocks done, and on nothing else.
[[nodiscard]] nlohmann::ordered_json summary_json(const RunDescription& description, const Model& model,
                                                  const Summary& summary, const CampaignOutcome& outcome);

/// The thirteen rows of a spreadsheet's descriptive statistics, and the quartiles.
[[nodiscard]] nlohmann::ordered_json statistics_json(const Tally& tally);

}  // namespace talus
