#include "talus/project/read_table.hpp"

#include <fmt/format.h>

namespace talus::project {
namespace {

constexpr std::size_t most_entries = 100'000;  // of one table; each may have problems to report

}  // namespace

void read_table(const Table& table, const Document& document, ValueReader& reader, const std::function<Row(int)>& add,
                std::string_view file_kind, Problems& problems) {
  const toml::node* node = table.key.empty() ? &document.root() : document.root().get(table.key);
  const auto refuse = [&](Problem problem, std::string what, std::string why) {
    problem.what = std::move(what);
    problem.why = std::move(why);
    problems.add(std::move(problem));
  };
  if (!node) {
    if (!table.required) return;
    refuse(document.nowhere(table.key), fmt::format("{} is missing", table.heading()),
           fmt::format("{} needs {}", file_kind, table.repeated ? "at least one" : "it"));
    return;
  }
  if (!table.repeated) {
    if (const toml::table* from = node->as_table()) {
      reader.read(table, *from, add(document.at(*node).line), name_of_row(table, *from, 0));
    } else {
      refuse(document.at(*node),
             node->is_array_of_tables() ? fmt::format("[[{}]] is a list of tables", table.key)
                                        : fmt::format("{} is {}", table.key, quoted(*node)),
             fmt::format("expected one table, {}", table.heading()));
    }
    return;
  }
  const toml::array* list = node->as_array();
  if (!list || (list->empty() && table.required)) {
    refuse(document.at(*node),
           node->is_table() ? fmt::format("[{}] is a single table", table.key)
                            : fmt::format("{} is {}", table.key, quoted(*node)),
           fmt::format("there may be several; expected {}", table.heading()));
    return;
  }
  if (list->size() > most_entries) {
    refuse(document.at(*node), fmt::format("{} has {} entries", table.heading(), list->size()),
           fmt::format("expected at most {}", most_entries));
    return;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::node& entry = (*list)[i];
    const Row row = add(document.at(entry).line);
    if (const toml::table* from = entry.as_table()) {
      reader.read(table, *from, row, name_of_row(table, *from, i));
    } else {
      refuse(document.at(entry), fmt::format("{}[{}] is {}", table.key, i, quoted(entry)),
             fmt::format("expected a table {}", table.heading()));
    }
  }
}

}  // namespace talus::project
