// `talus schema` and `talus new`: help for writing a project file.

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

}  // namespace talus::cli
