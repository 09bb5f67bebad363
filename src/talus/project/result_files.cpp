#include "talus/project/result_files.hpp"

#include <fstream>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/io/envelope_table.hpp"
#include "talus/io/map_files.hpp"
#include "talus/io/output_file.hpp"
#include "talus/io/run_state.hpp"
#include "talus/io/vector_out.hpp"
#include "talus/io/vtk_paths.hpp"

namespace talus::project {

namespace {

bool wants_vtk(const io::RunDescription& description) {
  const nlohmann::ordered_json::json_pointer place("/output/vtk");
  return description.project.contains(place) && description.project.at(place) == true;
}

bool ends_with_a_line(const std::filesystem::path& table) {
  std::ifstream file(table, std::ios::binary);
  file.seekg(-1, std::ios::end);
  return file.get() == '\n';
}

bool is_there(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && (file.extension() != ".csv" || ends_with_a_line(file)) &&
         !std::filesystem::exists(OutputFile::part_of(file), ignored);
}

void refuse(const std::filesystem::path& place, const char* why, Problems& problems) {
  problems.add({.file = place.string(),
                .what = "cannot write this result",
                .why = why,
                .hint = "Take it away, or write elsewhere",
                .option = "-o"});
}

}  // namespace

std::vector<std::string> result_files(const io::RunDescription& description, const std::optional<Shard>& shard) {
  std::vector<std::string> names{"endpoints.csv", "barriers.csv", "paths.csv"};
  if (!shard) {
    if (description.wants_maps && io::can_write_maps() && description.rocks > 0)
      names.emplace_back("maps/passages.tif");
    if (description.wants_envelopes) names.emplace_back(io::envelopes_name);
    if (description.design) names.insert(names.end(), {"design.csv", "design_ranking.csv"});
    if (description.wants_geopackage && io::can_write_geopackage()) names.emplace_back(io::geopackage_name);
    if (wants_vtk(description)) names.emplace_back(io::vtk_paths_name);
    if (description.wants_report) names.emplace_back("report.html");
  }
  names.emplace_back("summary.json");
  return names;
}

std::optional<std::string> lacking_file(const std::filesystem::path& folder, const io::RunDescription& description,
                                        const std::optional<Shard>& shard) {
  for (const std::string& name : result_files(description, shard)) {
    if (!is_there(folder / name)) return name;
  }
  return std::nullopt;
}

void check_that_results_have_room(const std::filesystem::path& folder, const io::RunDescription& description,
                                  const std::optional<Shard>& shard) {
  Problems problems;
  std::vector<std::string> names = result_files(description, shard);
  names.emplace_back(io::run_state_name);
  std::error_code ignored;
  for (const std::string& name : names) {
    const std::filesystem::path place = folder / name;
    for (const auto& each : {place, OutputFile::part_of(place)}) {
      if (std::filesystem::is_directory(each, ignored)) refuse(each, "it is a folder", problems);
    }
    const std::filesystem::path above = place.parent_path();
    if (std::filesystem::exists(above, ignored) && !std::filesystem::is_directory(above, ignored))
      refuse(above, "it is no folder", problems);
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

}  // namespace talus::project
