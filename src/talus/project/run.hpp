#pragma once
// A whole run: the model's rocks, and its results in a folder.

#include <filesystem>
#include <memory>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {

struct RunResult {
  CampaignOutcome outcome;
  Summary summary;
  Problems warnings;  // those that only the run could know
};

/// Runs the campaign and writes endpoints.csv, paths.csv, barriers.csv, summary.json, report.html and, in 3D, maps,
/// as the project asks. A run that is stopped writes what it has. Throws BadInput where the folder cannot be written
/// to; files are there whole or not at all.
RunResult run_into(const std::filesystem::path& folder, const Project& project, const Model& model,
                   const Problems& warnings, const CampaignOptions& options);

/// What makes maps of the model's rocks; nothing where the project wants none, or is 2D. Refers to the model.
[[nodiscard]] std::unique_ptr<MapObserver> map_observer(const Project& project, const Model& model);

/// Runs the campaign for its statistics alone.
RunResult run_in_memory(const Model& model, const CampaignOptions& options);

}  // namespace talus::project
