#include "run_model.hpp"

#include "talus/project/model.hpp"

namespace talus::server {

BuiltProject build(std::string_view text, const std::filesystem::path& file, const project::Overrides& overrides) {
  project::Reading reading = project::read_project_text(text, file, overrides);
  BuiltProject built{std::move(reading.project), {}, std::move(reading.warnings)};
  built.model = project::build_model(built.project, built.warnings);
  return built;
}

Problems seen_from(const std::filesystem::path& folder, const Problems& problems) {
  const std::string start = folder.string() + "/";
  Problems seen;
  for (Problem problem : problems.list()) {
    if (problem.file.starts_with(start)) problem.file.erase(0, start.size());
    seen.add(std::move(problem));
  }
  return seen;
}

}  // namespace talus::server
