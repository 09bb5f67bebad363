#include "run_model.hpp"

#include <variant>

#include "talus/model/model.hpp"

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
  const std::string start = folder.string() + "/";
  Problems seen;
  for (Problem problem : problems.list()) {
    if (problem.file.starts_with(start)) problem.file.erase(0, start.size());
    seen.add(std::move(problem));
  }
  return seen;
}

}  // namespace talus::server
