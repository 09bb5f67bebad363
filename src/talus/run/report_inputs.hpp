#pragma once
// The inputs of a run that its report lists: files with their checksums, sources of materials, the logo.

#include "talus/archive/run_summary.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Reads every input file of the project. Throws BadInput if the logo can no longer be read.
[[nodiscard]] ReportInputs report_inputs(const Project& project);
/// Those of its materials alone, without a file.
[[nodiscard]] std::vector<MaterialSource> material_sources(const Project& project);

}  // namespace talus::project
