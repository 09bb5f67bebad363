#include "run_model.hpp"

#include <variant>

#include "talus/model/model.hpp"
#include "talus/project/named_files.hpp"

namespace talus::server {

BuiltProject build(std::string_view text, const std::filesystem::path& file, const project::Overrides& overrides) {
  project::Reading reading = project::read_project_text(text, file, overrides);
  BuiltProject built{std::move(reading.project), {}, std::move(reading.warnings)};
  built.model = project::build_model(built.project, built.warnings);
  return built;
}

std::size_t bytes_of(const Model& model) {
  const std::size_t surface = std::visit(
      []<class Surface>(const Surface& of) {
        if constexpr (std::is_same_v<Surface, Profile>)
          return of.facet_count() * sizeof(Outline);
        else
          return of.bytes();
      },
      *model.surface);
  std::size_t panels = 0;
  for (const Barrier& barrier : model.barriers) panels += barrier.panels().size();
  constexpr std::size_t bytes_of_panel = sizeof(Panel) + 4 * sizeof(PlanBounds);
  return surface + panels * bytes_of_panel + model.barriers.size() * sizeof(Barrier) + model.ground.bytes() +
         model.parts.of_source->size() * sizeof(std::uint32_t);
}

Problems seen_from(const std::filesystem::path& folder, const Problems& problems) {
  Problems seen;
  for (Problem problem : problems.list()) {
    for (std::string* part : {&problem.file, &problem.what, &problem.why, &problem.hint})
      *part = project::with_relative_paths(std::move(*part), folder);
    seen.add(std::move(problem));
  }
  return seen;
}

}  // namespace talus::server
