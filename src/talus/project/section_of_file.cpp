#include "talus/project/section_of_file.hpp"

#include <utility>

#include "talus/import/section_file.hpp"
#include "talus/project/named_files.hpp"

namespace talus::project {

void read_section_of_file(Project& project, Problems& problems) {
  SectionTerrain& section = project.terrain.section;
  if (section.file.empty()) return;
  const std::filesystem::path file = project.file.parent_path() / section.file;
  Problems found;
  try {
    if (std::string why = why_unreadable(project, section.file); !why.empty()) {
      throw BadInput(Problem{.file = file.string(),
                             .where = {},
                             .what = "cannot be read",
                             .why = std::move(why),
                             .hint = "The path is relative to the project file"});
    }
    section.vertices = read_section_file({file, section.layer, section.tolerance_m.value_or(0)}, found);
  } catch (const BadInput& bad) {
    found.append(bad.problems());
  }
  problems.append(located_in_project(found, project, "[terrain]"));
}

}  // namespace talus::project
