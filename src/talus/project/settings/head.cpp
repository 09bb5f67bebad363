#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {

Table head_table() {
  return {
      .key = "",
      .meaning = "Keys before the first table.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Project::name),
               .without_it = "the name of the file, without `.toml`",
               .meaning = "Name of the project in the report, and of the folder with its results.",
               .source = "Talus"},
          },
      .add = [](Project& project) -> Row { return &project; },
      .rows = [](Project& project) { return std::vector<Row>{&project}; },
  };
}

}  // namespace talus::project::declared
