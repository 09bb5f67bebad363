// `talus schema` and `talus new`: help for writing a project file.

#include <fmt/format.h>

#include <memory>

#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/output_file.hpp"
#include "talus/project/schema.hpp"
#include "talus/project/starter.hpp"

namespace talus::cli {

namespace {

struct NewOptions {
  std::filesystem::path file;
  bool force = false;
};

int schema() {
  fmt::print("{}\n", project::schema().dump(2));
  return done;
}

int start_project(const NewOptions& options) {
  std::error_code unknown;  // writing the file reports a bad name
  if (!options.force && std::filesystem::exists(options.file, unknown)) {
    throw BadInput(Problem{.file = options.file.string(),
                           .what = "this file already exists",
                           .hint = "Choose another name, or overwrite it with --force"});
  }
  OutputFile file(place_of_file(options.file));
  file.write(project::starter());
  file.commit();
  fmt::print("Wrote {0}, a small project to start from; run it with `talus run {0}`\n", options.file.string());
  return done;
}

}  // namespace

Command add_schema(CLI::App& app) {
  return {app.add_subcommand("schema", "Print the JSON Schema of the project file"), schema};
}

Command add_new(CLI::App& app) {
  const auto options = std::make_shared<NewOptions>();
  CLI::App* command = app.add_subcommand("new", "Write a project file to start from");
  command->add_option("file", options->file, "File to write")->required()->check(names_file)->type_name("PROJECT.toml");
  command->add_flag("--force", options->force, "Overwrite an existing file");
  return {command, [options] { return start_project(*options); }};
}

}  // namespace talus::cli
