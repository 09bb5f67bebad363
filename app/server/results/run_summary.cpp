#include "results/run_summary.hpp"

#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

std::filesystem::path results_folder(const Run& run) {
  const auto refuse = [&](const char* why, const char* hint = "") {
    return Refusal(404, run.id, "this run has no results", why, hint);
  };
  if (has_results(run)) return run.folder;
  if (run.state == RunState::waiting) throw refuse("it is waiting for other runs");
  if (run.state == RunState::running) throw refuse("it is still running", "Stop it to see the results so far");
  if (run.is_active) throw refuse("they are being written", "Try again soon");
  if (run.state == RunState::interrupted)
    throw refuse("its server was killed", "Write the results so far with POST .../write");
  std::error_code ignored;
  const bool exists = std::filesystem::exists(run.folder / "summary.json", ignored);
  throw refuse(exists ? "its summary.json is not a regular file" : "it ended before they were written");
}

RunFacts read_facts(const Run& run) { return read_run_facts(results_folder(run)); }

Json settings_of(const Run& run, const std::filesystem::path& project_file) {
  return project::echo(
      project::read_project_text(project::text_of_file(run.folder / run_project_name), project_file, overrides_of(run))
          .project);
}

std::uint32_t Names::number(std::string_view name) {
  const auto [entry, is_new] = numbers_.try_emplace(std::string(name), static_cast<std::uint32_t>(list_.size()));
  if (is_new) list_.emplace_back(name);
  return entry->second;
}

std::optional<std::uint32_t> Names::find(std::string_view name) const {
  const auto found = numbers_.find(std::string(name));
  if (found == numbers_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::string> seeders_of(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const Json& seeder : facts.summary.project->value("seeder", Json::array()))
    names.push_back(seeder.is_object() && seeder.contains("name") && seeder["name"].is_string() ? seeder["name"]
                                                                                                : Json(""));
  return names;
}

std::vector<std::string> sources_of(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const SourceRocks& source : facts.summary.sources) names.push_back(source.name);
  return names;
}

std::vector<std::string> barriers_of(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const BarrierFacts& barrier : facts.barriers) names.push_back(barrier.name);
  return names;
}

}  // namespace talus::server
