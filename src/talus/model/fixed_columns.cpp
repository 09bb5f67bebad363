#include "talus/model/fixed_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "talus/project/differences.hpp"
#include "talus/project/echo.hpp"

namespace talus::project {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view prefix = "fixed:";
constexpr std::array limits{"analysis.max_steps", "analysis.max_time_s", "analysis.energy_datum_m"};

/// The settings of a project by their paths, those that are not set left out.
std::map<std::string, std::string> values_of(const Project& project) {
  std::map<std::string, std::string> values;
  for (const Difference& each : differences(echo(project), Json::object()))
    values[each.key] = each.here.is_string() ? each.here.get<std::string>() : each.here.dump();
  return values;
}

/// Tables whose entries a study may set, and another project may lack.
constexpr std::array tables_of_entries{"material.", "forest."};

bool is_of_entry(const std::string& path) {
  return std::ranges::any_of(tables_of_entries, [&](const char* table) { return path.starts_with(table); });
}

/// Where the paths of their settings begin: material.Scree.
std::vector<std::string> entries_of(const Project& project) {
  std::vector<std::string> entries;
  for (const Material& each : project.materials) entries.push_back(fmt::format("material.{}.", each.name));
  for (const ForestArea& each : project.forests) entries.push_back(fmt::format("forest.{}.", each.name));
  return entries;
}

bool is_law(const std::string& path) {
  return path.starts_with("analysis.") && std::ranges::find(limits, path) == limits.end();
}

/// Programs for tables write TRUE, and 5 for 5.0.
bool is_same(std::string_view a, std::string_view b, bool comma_is_point) {
  const auto x = number_in_cell(a, comma_is_point), y = number_in_cell(b, false);
  if (x && y) return *x == *y;
  return std::ranges::equal(
      a, b, {}, [](char c) { return std::tolower(static_cast<unsigned char>(c)); },
      [](char c) { return std::tolower(static_cast<unsigned char>(c)); });
}

}  // namespace

std::vector<FixedSetting> fixed_settings(const Project& project, const Project* as_written,
                                         std::span<const std::string> varied) {
  const auto written = as_written != nullptr ? values_of(*as_written) : std::map<std::string, std::string>();
  std::vector<FixedSetting> settings;
  for (const auto& [path, value] : values_of(project)) {
    if (std::ranges::find(varied, path) != varied.end()) continue;
    const auto before = written.find(path);
    const bool is_set = is_of_entry(path) && (before == written.end() || before->second != value);
    if (is_law(path) || is_set) settings.push_back({path, value});
  }
  return settings;
}

std::string fixed_column(std::string_view path, std::span<const std::string> sites) {
  std::string name = fmt::format("{}{}", prefix, path);
  for (const std::string& site : sites) name += "@" + site;
  return name;
}

bool is_fixed_column(std::string_view name) { return name.starts_with(prefix); }

FixedColumns::FixedColumns(const DataTable& table, const Project& project, std::string site)
    : project_(project), site_(std::move(site)) {
  const auto own = values_of(project);
  const std::vector<std::string> entries = entries_of(project);
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    if (!is_fixed_column(table.columns()[k])) continue;
    const std::string name = table.columns()[k].substr(prefix.size());
    // Names of entries may have an @: the path is the longest that the project has.
    std::size_t end = name.size();
    while (end != std::string::npos && !own.contains(name.substr(0, end))) end = name.rfind('@', end - 1);
    if (end == std::string::npos) end = name.find('@');
    Column column{.number = k, .path = name.substr(0, end), .first = {}, .sites = {}};
    for (std::string_view sites = std::string_view(name).substr(std::min(end, name.size())); !sites.empty();) {
      sites.remove_prefix(1);
      const std::size_t length = std::min(sites.find('@'), sites.size());
      column.sites.emplace_back(sites.substr(0, length));
      sites.remove_prefix(length);
    }
    const auto known = own.find(column.path);
    column.is_there = known != own.end();
    if (column.is_there) column.own = known->second;
    // A project without the material or forest has nothing to disagree.
    const auto is_its = [&](const std::string& entry) { return column.path.starts_with(entry); };
    if (!column.is_there && is_of_entry(column.path) && std::ranges::none_of(entries, is_its)) continue;
    if (!site_.empty() && !column.sites.empty() && std::ranges::find(column.sites, site_) == column.sites.end())
      continue;
    columns_.push_back(std::move(column));
  }
}

bool FixedColumns::agrees(const DataTable& table, const Column& column) const {
  return column.is_there && is_same(table.text(column.number), column.own, table.comma_is_point());
}

void FixedColumns::refuse(DataTable& table, const Column& column) const {
  const std::string of = column.sites.empty() ? std::string() : fmt::format(" at site \"{}\"", column.sites.front());
  table.refuse(fmt::format("its study has {} = {}{}, and {} has {}", column.path, table.text(column.number), of,
                           project_.file.filename().string(), column.is_there ? column.own : std::string("none")),
               "its parameters were found with that value",
               "Give the project this value, or calibrate with that of the project");
}

void FixedColumns::check(DataTable& table) {
  if (!is_first_) {
    for (const Column& column : columns_) {
      if (table.text(column.number) == column.first) continue;
      table.refuse(fmt::format("{} is {}", table.columns()[column.number], table.text(column.number)),
                   fmt::format("the first row has {}", column.first), "Keep the sets of one study in one file");
    }
    return;
  }
  is_first_ = false;
  for (Column& column : columns_) column.first = table.text(column.number);
  // Of several sites the project may be any.
  std::set<std::string> sites;
  for (const Column& column : columns_) sites.insert(column.sites.begin(), column.sites.end());
  const auto has = [](const Column& column, const std::string& site) {
    return column.sites.empty() || std::ranges::find(column.sites, site) != column.sites.end();
  };
  const auto is_of = [&](const std::string& site) {
    return std::ranges::all_of(columns_,
                               [&](const Column& column) { return !has(column, site) || agrees(table, column); });
  };
  if (sites.empty()) sites.insert(site_);
  if (std::ranges::any_of(sites, is_of)) return;
  for (const Column& column : columns_) {
    if (has(column, *sites.begin()) && !agrees(table, column)) refuse(table, column);
  }
}

}  // namespace talus::project
