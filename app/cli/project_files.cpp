// `talus schema` and `talus new`: what helps to write a project file.

#include <fmt/format.h>

#include "commands.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/output_file.hpp"
#include "talus/project/schema.hpp"
#include "talus/project/starter.hpp"

namespace talus::cli {

int schema() {
  fmt::print("{}\n", project::schema().dump(2));
  return done;
}

int start_project(const NewOptions& options) {
  std::error_code unknown;  // writing says what is wrong with the name
  if (!options.force && std::filesystem::exists(options.file, unknown)) {
    throw BadInput(Problem{.file = options.file.string(),
                           .what = "this file is there already",
                           .why = "talus new does not overwrite",
                           .hint = "Choose another name, or say --force"});
  }
  OutputFile file(place_of_file(options.file));
  file.write(project::starter());
  file.commit();
  fmt::print("{0} is a small project to change as you like; `talus run {0}` runs it\n", options.file.string());
  return done;
}

}  // namespace talus::cli
