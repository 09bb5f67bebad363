#pragma once
// Reads the files of empirical distributions.

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The project with the samples of its empirical distributions; those that it has already are kept. Throws BadInput
/// with the problems of all their files, located at the lines of the project that name them.
[[nodiscard]] Project read_samples(const Project& project, Problems& warnings);

}  // namespace talus::project
