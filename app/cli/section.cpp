#include <fmt/format.h>

#include <memory>
#include <utility>

#include "command_options.hpp"
#include "commands.hpp"
#include "earlier_output.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "talus/files/file_formats.hpp"
#include "talus/files/output_file.hpp"
#include "talus/lines/line_input.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/model/cut_section.hpp"
#include "talus/project/read.hpp"

namespace talus::cli {

namespace {

struct SectionOptions {
  std::filesystem::path terrain;  // a project, a raster or a mesh
  std::string line;               // as in LineOptions
  std::string crs;                // of a raster or mesh that names none; empty: that of the file
  double tolerance_m = 0;
  std::filesystem::path file;  // empty: standard output
};

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
    project.terrain.mesh.files = {name};
  } else {
    project.terrain.raster.file = name;
  }
  return project;
}

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

}  // namespace

Command add_section(CLI::App& app) {
  const auto options = std::make_shared<SectionOptions>();
  CLI::App* command = app.add_subcommand("section", "Cut a section from a terrain along a line on plan");
  command->add_option("terrain", options->terrain, "A raster or mesh in metres, or a project in 3D")
      ->required()
      ->check(names_file)
      ->type_name("TERRAIN");
  command
      ->add_option("--line", options->line,
                   "Corners \"x,y x,y ...\", a table (.csv) with the columns x_m and y_m, or a GIS file with one line")
      ->required()
      ->check(names_line)
      ->type_name("LINE");
  command
      ->add_option("--tolerance", options->tolerance_m,
                   "Leave out vertices within this distance of the line through the others")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("M");
  command->add_option("--crs", options->crs, "Coordinate system of a file that names none, or \"local\"")
      ->type_name("CRS");
  command->add_option("-o,--output", options->file, "File for the table (default: standard output)")
      ->check(names_file)
      ->type_name("FILE.csv");
  return {command, [options] { return section(*options); }};
}

}  // namespace talus::cli
