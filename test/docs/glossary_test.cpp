// The glossary is sorted, and all names in it exist: settings in the schema, columns in the tables of a run, and maps.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/places.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/project/schema.hpp"

namespace talus::test {
namespace {

using nlohmann::ordered_json;
using ::testing::IsEmpty;

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(' '), to = text.find_last_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

struct Entry {
  std::string term;
  std::string meaning;
  std::string where;
};

std::vector<Entry> glossary() {
  std::vector<Entry> entries;
  std::ifstream in(talus::places::in_source("/docs/glossary.md"));
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("| ") || line.starts_with("| term ") || line.starts_with("| --- ")) continue;
    const std::vector<std::string> cells = parts_of(line, '|');
    EXPECT_EQ(cells.size(), 5U) << line;
    if (cells.size() == 5U) entries.push_back({trimmed(cells[1]), trimmed(cells[2]), trimmed(cells[4])});
  }
  return entries;
}

/// The names in an entry's last cell.
std::vector<std::string> names_in(const std::string& where) {
  static const std::regex code("`([^`]*)`");
  std::vector<std::string> names;
  for (std::sregex_iterator it(where.begin(), where.end(), code), end; it != end; ++it) names.push_back((*it)[1]);
  return names;
}

/// The problem with `table.key`, or `table.key.part` of a random property, and one of its words; empty if none.
std::string problem_of_setting(const std::string& name, const std::string& word) {
  static const ordered_json schema = project::schema();
  const std::vector<std::string> keys = parts_of(name, '.');
  ordered_json node = schema;
  for (const std::string& key : keys) {
    if (node.contains("items")) node = ordered_json(node.at("items"));
    if (node.contains("anyOf")) node = ordered_json(node.at("anyOf").back());
    if (!node.contains("properties") || !node.at("properties").contains(key)) return name + ": no setting";
    node = ordered_json(node.at("properties").at(key));
  }
  if (keys.size() < 2) return name + ": a table";
  if (word.empty()) return {};
  const bool known = node.contains("enum") && std::ranges::count(node.at("enum"), ordered_json(word)) > 0;
  return known ? "" : name + " is never " + word;
}

/// The words that a column of words may have.
std::set<std::string> words_of(const std::string& column) {
  std::set<std::string> words;
  const auto add_all = [&](const auto& values) {
    for (const auto value : values) words.insert(name(value));
  };
  if (column == "end_reason") add_all(Words<EndReason>::values);
  if (column == "state") add_all(Words<PathState>::values);
  if (column == "outcome") add_all(Words<BarrierOutcome>::values);
  return words;
}

/// A run with every table.
class RunWithTables {
 public:
  RunWithTables() {
    const std::string project = folder_.write("project.toml", bytes_of(tutorial("2d")) + "\n[design]\n");
    said_ = talus_says("run " + project + " --quiet --set output.impacts=all -o " + (folder_ / "out").string());
  }
  [[nodiscard]] const Said& said() const { return said_; }
  [[nodiscard]] std::string problem_of_column(const std::string& file, const std::string& column,
                                              const std::string& word) const {
    std::ifstream in(folder_ / ("out/" + file));
    std::string heading;
    std::getline(in, heading);
    if (std::ranges::count(parts_of(heading, ','), column) == 0) return file + " has no column " + column;
    return word.empty() || words_of(column).contains(word) ? "" : column + " is never " + word;
  }

 private:
  Workplace folder_;
  Said said_;
};

bool is_map(const std::string& name) {
  const std::vector<MapKind> kinds = map_kinds({.percentiles = {50, 95, 99}});
  return std::ranges::any_of(kinds, [&](const MapKind& kind) { return kind.name == name; });
}

/// The problem with a name in the glossary; empty if none.
std::string problem_of(const std::string& name, const RunWithTables& run) {
  static const std::regex map(R"(maps/(\w+)\.tif)"), column(R"lit((\w+\.csv):(\w+)(?: = "([^"]*)")?)lit"),
      setting(R"lit(([a-z]\w*(?:\.\w+)+)(?: = "([^"]*)")?)lit");
  std::smatch match;
  if (std::regex_match(name, match, map)) return is_map(match[1]) ? "" : name + ": no map";
  if (std::regex_match(name, match, column)) return run.problem_of_column(match[1], match[2], match[3]);
  if (std::regex_match(name, match, setting)) return problem_of_setting(match[1], match[2]);
  return name + ": neither a setting nor a column nor a map";
}

TEST(Glossary, UsesExistingNames) {
  const RunWithTables run;
  ASSERT_EQ(run.said().exit_code, 0) << run.said().text;
  const std::vector<Entry> entries = glossary();
  EXPECT_GT(entries.size(), 40U);
  for (const Entry& entry : entries) {
    EXPECT_FALSE(entry.meaning.empty()) << entry.term;
    const std::vector<std::string> names = names_in(entry.where);
    if (entry.where.starts_with("see ")) {
      const std::string other = entry.where.substr(4);
      EXPECT_TRUE(std::ranges::any_of(entries, [&](const Entry& one) { return one.term == other; })) << entry.term;
    } else {
      EXPECT_FALSE(names.empty()) << entry.term << " has no place of use";
    }
    for (const std::string& name : names) EXPECT_EQ(problem_of(name, run), "") << entry.term;
  }
}

TEST(Glossary, IsAlphabetical) {
  std::vector<std::string> terms;
  for (const Entry& entry : glossary()) {
    terms.push_back(entry.term);
    std::ranges::transform(terms.back(), terms.back().begin(), [](unsigned char c) { return std::tolower(c); });
  }
  EXPECT_TRUE(std::ranges::is_sorted(terms));
  EXPECT_EQ(std::ranges::adjacent_find(terms), terms.end()) << "a term is there twice";
}

TEST(Glossary, ReportsNamesThatDoNotExist) {
  const RunWithTables run;
  EXPECT_EQ(problem_of("seeder.weight_kg", run), "seeder.weight_kg: no setting");
  EXPECT_EQ(problem_of("material.normal_restitution.median", run), "material.normal_restitution.median: no setting");
  EXPECT_EQ(problem_of("analysis.model = \"cube\"", run), "analysis.model is never cube");
  EXPECT_EQ(problem_of("endpoints.csv:speed", run), "endpoints.csv has no column speed");
  EXPECT_EQ(problem_of("paths.csv:state = \"asleep\"", run), "state is never asleep");
  EXPECT_EQ(problem_of("maps/energy.tif", run), "maps/energy.tif: no map");
  EXPECT_EQ(problem_of("runout", run), "runout: neither a setting nor a column nor a map");
}

}  // namespace
}  // namespace talus::test
