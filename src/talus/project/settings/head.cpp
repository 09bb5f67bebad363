#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {

Table head_table() {
  return {
      .key = "",
      .meaning = "Stands before the first table.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Project::name),
               .without_it = "the name of the file, without `.toml`",
               .meaning = "What the project is called in the report, and the name of the folder with its results.",
               .source = "Talus"},
          },
      .add = [](Project& project) -> Row { return &project; },
      .rows = [](Project& project) { return std::vector<Row>{&project}; },
  };
}

}  // namespace talus::project::declared
