#include "talus/lines/line_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <utility>
#include <variant>

#include "talus/files/data_table.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;

/// The words of a text, separated by blanks or semicolons.
std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n;";
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

std::vector<PlanPlace> places_in_text(std::string_view text, bool in_section, std::string_view where) {
  std::vector<PlanPlace> places;
  Problems problems;
  for (const std::string_view word : words_of(text)) {
    const std::size_t comma = word.find(',');
    const auto x = number_in_cell(word.substr(0, comma), false);
    const bool has_y = comma != std::string_view::npos;
    const auto y = has_y ? number_in_cell(word.substr(comma + 1), false) : std::optional<double>(0);
    if (!x || !y || (!has_y && !in_section)) {
      problems.add({.where = std::string(where),
                    .what = fmt::format("\"{}\" is not a place", word),
                    .why = in_section ? "expected x" : "expected x,y",
                    .hint = in_section ? "" : "Write \"x,y x,y ...\", or name a file that exists"});
      continue;
    }
    places.push_back({*x, *y});
  }
  if (problems.has_errors()) throw BadInput(problems);
  return places;
}

std::vector<PlanPlace> places_in_table(const fs::path& file) {
  DataTable table(file);
  const auto columns = table.columns();
  const auto find = [&](std::string_view name) -> std::size_t {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string plain = plain_column_name(columns[k]);
      if (plain == name || plain == fmt::format("{}_m", name)) return k;
    }
    throw BadInput(Problem{.file = file.string(),
                           .line = 1,
                           .what = fmt::format("there is no column {}_m", name),
                           .why = fmt::format("the columns are {}", fmt::join(columns, ", ")),
                           .hint = "A row is a corner: x_m, y_m"});
  };
  const std::size_t x = find("x"), y = find("y");
  std::vector<PlanPlace> places;
  while (table.next()) {
    PlanPlace& place = places.emplace_back();
    for (const auto& [column, value] : {std::pair(x, &place[0]), std::pair(y, &place[1])}) {
      const auto number = number_in_cell(table.text(column), table.comma_is_point());
      if (number) {
        *value = *number;
      } else {
        table.refuse(fmt::format("{} is \"{}\"", columns[column], table.text(column)), "expected a number");
      }
    }
  }
  table.throw_if_any();
  return places;
}

std::vector<PlanPlace> places_in_layer(const fs::path& file, PlanShape shape, const Model& model, Problems& warnings) {
  const bool wants_line = shape == PlanShape::line;
  const VectorRequest request{.layer = "",
                              .layer_key = "layer",
                              .attributes = {},
                              .kinds = {wants_line ? ShapeKind::line : ShapeKind::polygon},
                              .terrain_crs_wkt = model.crs_wkt};
  const VectorLayer layer = read_vector_file(file, request, warnings);
  const char* const name = wants_line ? "line" : "polygon";
  std::vector<const VectorShape*> shapes;
  for (const VectorFeature& feature : layer.features) {
    for (const VectorShape& part : feature.parts) shapes.push_back(&part);
  }
  if (shapes.size() != 1) {
    throw BadInput(Problem{.file = file.string(),
                           .what = fmt::format("has {} {}s", shapes.size(), name),
                           .why = "one is asked at a time",
                           .hint = fmt::format("Save the {} that you ask for in a file of its own", name)});
  }
  if (shapes.front()->lists.size() > 1) {
    throw BadInput(Problem{
        .file = file.string(), .what = "its polygon has holes", .why = "only polygons without holes can be asked for"});
  }
  std::vector<PlanPlace> places;
  for (const Vec3& p : shapes.front()->lists.front()) places.push_back({p.x(), p.y()});
  return places;
}

}  // namespace

std::vector<PlanPlace> places_given(std::string_view given, PlanShape shape, const Model& model, std::string_view where,
                                    Problems& warnings) {
  const fs::path file(given);
  std::error_code ignored;
  // A text with a comma or a blank, or a number, is coordinates unless there is a file of that name.
  const bool is_text = given.find_first_of(", \t;") != std::string_view::npos || number_in_cell(given, false);
  if (is_text && !fs::exists(file, ignored))
    return places_in_text(given, std::holds_alternative<Profile>(*model.surface), where);
  if (!fs::exists(file, ignored)) {
    throw BadInput(Problem{.where = std::string(where),
                           .what = fmt::format("\"{}\" cannot be read", given),
                           .why = "there is no such file",
                           .hint = "Write \"x,y x,y ...\", or name a file that exists"});
  }
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".csv" || ending == ".txt" || ending == ".tsv") return places_in_table(file);
  return places_in_layer(file, shape, model, warnings);
}

}  // namespace talus
