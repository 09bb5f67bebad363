#include "talus/export/derived_files.hpp"

#include <system_error>

#include "talus/archive/run_facts.hpp"
#include "talus/export/vector_out.hpp"
#include "talus/export/vtk_paths.hpp"

namespace talus {

void write_derived_files(const std::filesystem::path& folder, const char* summary) {
  std::error_code ignored;
  std::filesystem::remove(folder / geopackage_name, ignored);
  std::filesystem::remove(folder / vtk_paths_name, ignored);
  const RunFacts facts = read_run_facts(folder, summary);
  if (facts.wants_geopackage && can_write_geopackage()) write_geopackage(facts, folder);
  if (facts.wants_vtk) write_vtk_paths(folder);
}

}  // namespace talus
