#include "talus/model/site_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "talus/files/names_in_words.hpp"
#include "talus/model/fixed_columns.hpp"
#include "talus/project/parameter.hpp"

namespace talus::project {

namespace {

struct SitedColumn {
  std::size_t column;
  std::string path;
  std::vector<std::string> sites;  // empty: all

  [[nodiscard]] bool is_of(const std::string& site) const { return std::ranges::find(sites, site) != sites.end(); }
};

bool is_number_of(const Project& project, std::string_view path) {
  Problems ignored;
  return SettingNumber::find(project, path, {}, ignored).has_value();
}

/// The path and the sites of a column's name. Names of materials may have an @ as well: the path ends before the first
/// one that makes it that of a number of the project, or else before the first.
SitedColumn divided(const Project& project, std::size_t column, const std::string& name) {
  std::size_t end = name.find('@');
  if (end == std::string::npos || is_number_of(project, name)) return {column, name, {}};
  for (std::size_t at = end; at != std::string::npos; at = name.find('@', at + 1)) {
    if (!is_number_of(project, std::string_view(name).substr(0, at))) continue;
    end = at;
    break;
  }
  SitedColumn divided{column, name.substr(0, end), {}};
  for (std::size_t begin = end; begin != std::string::npos; begin = end) {
    end = name.find('@', begin + 1);
    divided.sites.push_back(name.substr(begin + 1, end == std::string::npos ? end : end - begin - 1));
  }
  return divided;
}

Problem about_site(const Project& project, std::string why, std::string hint) {
  return {.file = project.file.string(),
          .where = "[sampling]",
          .what = fmt::format("parameters_site is \"{}\"", project.sampling.parameters_site),
          .why = std::move(why),
          .hint = std::move(hint),
          .path = "sampling.parameters_site"};
}

/// The site whose columns apply; nullopt, with a problem, if it is not clear.
std::optional<std::string> chosen_site(const std::vector<SitedColumn>& columns, const Project& project,
                                       const std::string& file, Problems& problems) {
  std::vector<std::string> sites, fitting;
  for (const SitedColumn& each : columns) {
    for (const std::string& site : each.sites) {
      if (std::ranges::find(sites, site) == sites.end()) sites.push_back(site);
    }
  }
  const std::string& wanted = project.sampling.parameters_site;
  if (!wanted.empty()) {
    if (std::ranges::find(sites, wanted) != sites.end()) return wanted;
    const std::string table = project.sampling.parameters.filename().string();
    problems.add(
        sites.empty()
            ? about_site(project, fmt::format("the columns of {} are those of all sites", table), "Leave it out")
            : about_site(project, fmt::format("{} has columns of {}", table, listed(sites)), meant(wanted, sites)));
    return std::nullopt;
  }
  if (sites.size() <= 1) return sites.empty() ? "" : sites.front();
  std::ranges::copy_if(sites, std::back_inserter(fitting), [&](const std::string& site) {
    return std::ranges::all_of(
        columns, [&](const SitedColumn& each) { return !each.is_of(site) || is_number_of(project, each.path); });
  });
  if (fitting.size() == 1) return fitting.front();
  problems.add({.file = file,
                .line = 1,
                .where = {},
                .what = fmt::format("has columns of the sites {}", listed(sites)),
                .why = "it is not clear which one the project is",
                .hint = fmt::format("Write parameters_site = \"{}\" in [sampling]",
                                    fitting.empty() ? sites.front() : fitting.front())});
  return std::nullopt;
}

}  // namespace

ParameterColumns parameter_columns(std::span<const std::string> names, const Project& project, const std::string& file,
                                   Problems& problems) {
  std::vector<SitedColumn> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (is_fixed_column(names[k])) continue;
    SitedColumn each = divided(project, k, names[k]);
    if (each.path.find('.') != std::string::npos) columns.push_back(std::move(each));
  }
  const auto site = chosen_site(columns, project, file, problems);
  ParameterColumns chosen;
  if (!site) return chosen;
  chosen.site = *site;
  for (SitedColumn& each : columns) {
    if (each.sites.empty() || each.is_of(*site)) chosen.list.push_back({each.column, std::move(each.path)});
  }
  return chosen;
}

}  // namespace talus::project
