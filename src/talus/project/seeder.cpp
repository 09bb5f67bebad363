#include "talus/project/seeder.hpp"

namespace talus::project {

ReleaseWay Seeder::way() const {
  if (is_of_cells()) return std::cref(in_cells);
  if (type == SeederType::table) return std::cref(from_table);
  if (!along_lines.file.empty()) return std::cref(along_lines);
  return std::cref(at_points);
}

}  // namespace talus::project
