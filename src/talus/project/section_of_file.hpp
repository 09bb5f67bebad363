#pragma once
// The vertices of a section that is in a file.

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Fills the vertices of the section from its file, if the project names one. Errors and warnings of the file are added
/// to `problems`, at the line that names it; after an error there are no vertices.
void read_section_of_file(Project& project, Problems& problems);

}  // namespace talus::project
