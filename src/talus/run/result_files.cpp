#include "talus/run/result_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>

#include "talus/archive/design_tables.hpp"
#include "talus/archive/envelope_table.hpp"
#include "talus/archive/figure_counts.hpp"
#include "talus/archive/result_tables.hpp"
#include "talus/archive/run_state.hpp"
#include "talus/archive/uncertainty_table.hpp"
#include "talus/core/problems.hpp"
#include "talus/export/vector_out.hpp"
#include "talus/export/vtk_paths.hpp"
#include "talus/files/file_record.hpp"
#include "talus/files/output_file.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/maps/source_maps.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus::project {

namespace {

bool wants_vtk(const RunDescription& description) {
  const nlohmann::ordered_json::json_pointer place("/output/vtk");
  return description.project.contains(place) && description.project.at(place) == true;
}

bool ends_with_a_line(const std::filesystem::path& table) {
  std::ifstream file(table, std::ios::binary);
  file.seekg(-1, std::ios::end);
  return file.get() == '\n';
}

bool is_complete(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && (file.extension() != ".csv" || ends_with_a_line(file)) &&
         !std::filesystem::exists(OutputFile::part_of(file), ignored);
}

void refuse(const std::filesystem::path& place, const char* why, Problems& problems) {
  problems.add({.file = place.string(),
                .what = "cannot write this result",
                .why = why,
                .hint = "Remove it, or write elsewhere",
                .option = "-o"});
}

}  // namespace

namespace {

/// Whether a run writes a file of this name (relative to its folder), or removes one that an earlier run wrote.
bool is_name_of_result(const std::filesystem::path& name) {
  const std::string first = name.begin()->string();
  if (first == "maps") return is_name_of_map_file(name) || name.filename() == SourceRow::file_name;
  std::string plain = name.string();
  if (plain.ends_with(".part")) plain.erase(plain.size() - std::string_view(".part").size());
  constexpr auto names = std::to_array<std::string_view>(
      {DesignRow::file_name, RankingRow::file_name, PairRow::file_name, EnvelopeRow::file_name,
       UncertaintyRow::file_name, geopackage_name, vtk_paths_name, trajectories_name, run_state_name, file_record_name,
       "summary.json", "report.html"});
  return std::ranges::find(names, plain) != names.end() ||
         std::ranges::find(result_tables(), plain, &ResultTable::file_name) != result_tables().end();
}

}  // namespace

std::vector<std::string> result_files(const RunDescription& description, const std::optional<Shard>& shard) {
  std::vector<std::string> names;
  for (const ResultTable* table : tables_with(rocks_in_tables(description))) names.emplace_back(table->file_name);
  if (!shard) {
    if (description.wants_maps && description.maps && can_write_maps() && description.rocks > 0)
      names.push_back("maps/" + map_kinds(description.maps->selection).front().name + ".tif");
    if (description.wants_envelopes) names.emplace_back(EnvelopeRow::file_name);
    if (description.design) names.insert(names.end(), {DesignRow::file_name, RankingRow::file_name});
    if (description.design && !description.design->pairs.empty()) names.emplace_back(PairRow::file_name);
    if (ensembles_of(description.project) > 0) names.emplace_back(UncertaintyRow::file_name);
    if (description.wants_geopackage && can_write_geopackage()) names.emplace_back(geopackage_name);
    if (description.store_bytes) names.emplace_back(trajectories_name);
    if (wants_vtk(description)) names.emplace_back(vtk_paths_name);
    if (description.wants_report) names.emplace_back("report.html");
  }
  names.emplace_back("summary.json");
  return names;
}

std::optional<std::string> lacking_file(const std::filesystem::path& folder, const RunDescription& description,
                                        const std::optional<Shard>& shard) {
  for (const std::string& name : result_files(description, shard)) {
    if (!is_complete(folder / name)) return name;
  }
  return changed_file(folder);
}

std::vector<std::string> written_files(const std::filesystem::path& folder, const RunDescription& description,
                                       const std::optional<Shard>& shard) {
  std::vector<std::string> names;
  std::error_code error;
  for (std::string& name : result_files(description, shard)) {
    const auto place = folder / name;
    if (std::filesystem::exists(place, error) || std::filesystem::exists(OutputFile::part_of(place), error))
      names.push_back(std::move(name));
  }
  if (shard) return names;
  for (auto entry = std::filesystem::recursive_directory_iterator(folder / "maps", error);
       !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
    // Styles are not recorded, because users may change them.
    const std::filesystem::path& file = entry->path();
    if ((file.extension() == ".tif" && is_name_of_map_file(file)) || file.filename() == SourceRow::file_name)
      names.push_back(file.lexically_relative(folder).generic_string());
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void check_that_inputs_are_kept(const std::filesystem::path& folder, const Project& project) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path results = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) return;
  Problems problems;
  const std::vector<std::string> recorded = recorded_files(folder);
  const auto check = [&](const fs::path& file, Problem problem) {
    const fs::path real = fs::canonical(file, error);
    if (error) return;
    const fs::path within = real.lexically_relative(results);
    if (within.empty() || *within.begin() == "..") return;
    const bool is_recorded = std::ranges::find(recorded, within.generic_string()) != recorded.end();
    if (!is_name_of_result(within) && !is_recorded) return;
    problem.why = is_name_of_result(within) ? "a run writes its results there and would replace it"
                                            : "it is a result of an earlier run, which this one replaces";
    problem.hint = "Give the file another name, or write elsewhere";
    problem.option = "-o";
    problems.add(std::move(problem));
  };
  check(project.file, {.file = project.file.string(), .what = fmt::format("is in {}", folder.string())});
  for (const NamedFile& named : project.named_files) {
    check(project.file.parent_path() / named.file,
          {.file = named.named_in,
           .line = named.line,
           .where = named.where,
           .what = fmt::format("{} {} is in {}", named.key, named.file.string(), folder.string()),
           .path = named.path});
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

void check_that_results_have_room(const std::filesystem::path& folder, const RunDescription& description,
                                  const std::optional<Shard>& shard) {
  Problems problems;
  std::vector<std::string> names = result_files(description, shard);
  names.insert(names.end(), {run_state_name, file_record_name});
  std::error_code ignored;
  for (const std::string& name : names) {
    const std::filesystem::path place = folder / name;
    for (const auto& each : {place, OutputFile::part_of(place)}) {
      if (std::filesystem::is_directory(each, ignored)) refuse(each, "it is a folder", problems);
    }
    const std::filesystem::path above = place.parent_path();
    if (std::filesystem::exists(above, ignored) && !std::filesystem::is_directory(above, ignored))
      refuse(above, "it is not a folder", problems);
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

}  // namespace talus::project
