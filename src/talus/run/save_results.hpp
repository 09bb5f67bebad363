#pragma once
// Writes a run that was simulated in memory.

#include <filesystem>
#include <functional>

#include "talus/archive/table_files.hpp"
#include "talus/campaign/model.hpp"
#include "talus/project/project.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {

/// Writes the results to a folder: the files of run_into(), with the same bytes except for the timings. `description`
/// is that of describe_run() with the inputs of the run; `write_rows` appends the rows of all tables. An interrupted
/// run cannot be resumed from them. Throws BadInput as run_into() does, and Stopped at the request of the thread's
/// StopScope.
WrittenResults save_results(const std::filesystem::path& folder, const Project& project, const Model& model,
                            const RunDescription& description, RunSums& sums, const RunCourse& course,
                            const std::function<void(TableFiles&)>& write_rows);

}  // namespace talus::project
