#include <fmt/format.h>

#include <utility>

#include "commands.hpp"
#include "earlier_output.hpp"
#include "load.hpp"
#include "talus/files/file_formats.hpp"
#include "talus/files/output_file.hpp"
#include "talus/lines/line_input.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/model/cut_section.hpp"
#include "talus/project/read.hpp"

namespace talus::cli {

namespace {

/// The project, or one with nothing but a terrain from one file.
project::Project project_of_terrain(const SectionOptions& options, Problems& warnings) {
  project::Project project;
  if (options.terrain.extension() == ".toml") {
    if (!options.crs.empty()) {
      throw BadInput(Problem{.where = "--crs",
                             .what = "is given for a project",
                             .why = "a project names its own coordinate system",
                             .hint = "Set it there: terrain.crs"});
    }
    project::Reading reading = project::read_project(options.terrain, {});
    warnings = std::move(reading.warnings);
    return std::move(reading.project);
  }
  project.file = options.terrain;
  project.terrain.crs = options.crs;
  const std::filesystem::path name = options.terrain.filename();
  if (is_of_kind(name, FileKind::mesh)) {
    project.terrain.meshes = {name};
  } else {
    project.terrain.raster = name;
  }
  return project;
}

}  // namespace

int section(const SectionOptions& options) {
  if (!options.file.empty()) refuse_other_files(options.file, section_header, "table of a section");
  Problems warnings;
  const project::Project project = project_of_terrain(options, warnings);
  project::BuiltTerrain built = project::build_terrain(project, warnings);
  Model model;
  model.surface = std::move(built.surface);
  model.frame = built.frame;
  model.crs_wkt = std::move(built.crs_wkt);
  const auto line = places_given(options.line, PlanShape::line, model, "--line", warnings);
  const std::vector<SectionVertex> cut = cut_section(*model.surface, model.frame, line, options.tolerance_m, "--line");
  print_warnings(warnings);
  const std::string table = section_table(cut);
  if (options.file.empty()) {
    fmt::print("{}", table);
    return done;
  }
  OutputFile out(place_of_file(options.file));
  out.write(table);
  out.commit();
  fmt::print("{} vertices over {:.6g} m. In a project: section = \"{}\"\n", cut.size(), cut.back().distance,
             options.file.filename().string());
  return done;
}

}  // namespace talus::cli
