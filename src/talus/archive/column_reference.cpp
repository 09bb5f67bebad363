#include "talus/archive/column_reference.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "talus/archive/column_statistics.hpp"
#include "talus/archive/design_tables.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/maps/map_list.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

const char* kind_name(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::word:
      return "word";
    case ColumnKind::key:
      return "key";
    case ColumnKind::quantity:
      return "quantity";
  }
  return "";
}

void add_object(const char* name, const std::vector<std::pair<std::string, Json>>& members, std::string& out) {
  out += fmt::format("\nexport const {} = {{\n", name);
  for (const auto& [member, value] : members) out += fmt::format("  {}: {},\n", member, value.dump());
  out += "} as const;\n";
}

void add_table(const char* name, const std::vector<ColumnText>& columns, std::string& out) {
  std::vector<std::pair<std::string, Json>> members;
  for (const ColumnText& column : columns)
    members.emplace_back(column.name,
                         Json{{"kind", kind_name(column.kind)}, {"unit", column.unit}, {"meaning", column.meaning}});
  add_object(name, members, out);
}

void add_numbers(const char* name, const std::vector<NumberColumn>& columns, std::string& out) {
  std::vector<std::pair<std::string, Json>> members;
  for (const NumberColumn& column : columns)
    members.emplace_back(std::string(column.name), Json{{"unit", std::string(column.unit)}});
  add_object(name, members, out);
}

/// How many of the first columns one row describes, and what it says: components of a vector, ends of an interval.
std::pair<std::size_t, std::string> described_together(std::span<const ColumnText> columns) {
  const ColumnText& first = columns.front();
  const auto follows = [&](std::size_t k, std::string_view lead) {
    return k < columns.size() && columns[k].unit == first.unit && columns[k].meaning.starts_with(lead);
  };
  constexpr std::string_view x = "x of ", lower = "lower end", upper = "upper end";
  if (first.meaning.starts_with(x)) {
    const std::string_view whole = std::string_view(first.meaning).substr(x.size());
    std::string letters = "x";
    std::size_t count = 1;
    for (const char* lead : {"y of ", "z of "}) {
      if (!follows(count, lead)) break;
      const std::string_view rest = std::string_view(columns[count].meaning).substr(x.size());
      if (rest != "it" && !whole.starts_with(rest)) break;
      letters += fmt::format(", {}", lead[0]);
      ++count;
    }
    if (count > 1) return {count, fmt::format("{} of {}", letters, whole)};
  }
  if (first.meaning.starts_with(lower) && follows(1, upper)) {
    const std::string_view of = std::string_view(first.meaning).substr(lower.size());
    const std::string_view rest = std::string_view(columns[1].meaning).substr(upper.size());
    if (rest.empty() || rest == of) return {2, fmt::format("ends{}", of)};
  }
  return {1, first.meaning};
}

}  // namespace

std::string column_table(std::span<const ColumnText> columns) {
  std::string out = "| column | unit | what |\n| --- | --- | --- |\n";
  for (std::size_t k = 0; k < columns.size();) {
    const auto [count, meaning] = described_together(columns.subspan(k));
    std::string names;
    for (std::size_t i = k; i < k + count; ++i) names += fmt::format("{}`{}`", i > k ? ", " : "", columns[i].name);
    out += fmt::format("| {} | {} | {} |\n", names, columns[k].unit, meaning);
    k += count;
  }
  return out;
}

std::string columns_module() {
  std::string out =
      R"(// Made from the declarations of the tables of a run (src/talus/archive/table_columns.hpp) by column_reference.cpp; not
// written by hand. To renew it: TALUS_RENEW_REFERENCE=1 and run the test ColumnsModule.IsNotStale.
)";
  add_table("endpointColumns", column_texts<EndpointRow>(), out);
  add_table("pathColumns", column_texts<PathEventRow>(), out);
  add_table("hitColumns", column_texts<HitRow>(), out);
  out += "\n// What statistics are made of: the quantities of a table, and what follows from them.\n";
  add_numbers("endpointNumbers", endpoint_numbers(), out);
  add_numbers("hitNumbers", barrier_numbers(), out);
  out += "\n// The quantities of a design, as summary.json names them.\n";
  std::vector<std::pair<std::string, Json>> members;
  for (const DesignQuantity& quantity : design_quantities)
    members.emplace_back(key_of(quantity), Json{{"unit", std::string(quantity.unit)}});
  add_object("designQuantities", members, out);
  out += "\n// What maps and envelopes.csv show, along a section (src/talus/maps/map_subjects.hpp).\n";
  members.clear();
  for (const SectionFigure& figure : section_figures())
    members.emplace_back(
        std::string(figure.name),
        Json{{"title", std::string(figure.title)}, {"unit", std::string(figure.unit)}, {"per", figure.per}});
  add_object("sectionFigures", members, out);
  return out;
}

}  // namespace talus
