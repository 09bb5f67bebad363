#include "talus/archive/run_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "talus/archive/foot_stretch.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/json_file.hpp"

namespace talus::io {

namespace {

using Json = nlohmann::json;

constexpr const char* hint = "Name a folder that `talus run` has written";

/// Values by their place, "/rocks/planned"; refused where they are not there or not of the kind expected.
class Values {
 public:
  /// Of what stands at `beginning` in the file: places begin with it.
  Values(std::filesystem::path file, Json json, std::string beginning = "")
      : file_(std::move(file)), json_(std::move(json)), beginning_(std::move(beginning)) {}

  [[nodiscard]] bool has(const std::string& place) const { return json_.contains(within(place)); }
  [[nodiscard]] const Json& at(const std::string& place) const {
    if (!has(place)) refuse(place, "is missing", "a run writes it");
    return json_.at(within(place));
  }
  [[nodiscard]] const Json& list(const std::string& place) const {
    return of_kind(place, at(place).is_array(), "a list");
  }
  [[nodiscard]] std::string text(const std::string& place) const {
    return of_kind(place, at(place).is_string(), "a text").get<std::string>();
  }
  [[nodiscard]] double number(const std::string& place) const {
    return of_kind(place, at(place).is_number(), "a number").get<double>();
  }
  [[nodiscard]] std::uint64_t count(const std::string& place) const {
    return of_kind(place, at(place).is_number_unsigned(), "a whole number, 0 or more").get<std::uint64_t>();
  }
  [[nodiscard]] bool flag(const std::string& place) const {
    return of_kind(place, at(place).is_boolean(), "true or false").get<bool>();
  }
  /// Nothing for null.
  [[nodiscard]] std::optional<double> number_if_any(const std::string& place) const {
    return at(place).is_null() ? std::nullopt : std::optional(number(place));
  }
  /// "all" (nothing), "none" (0) or a number of rocks.
  [[nodiscard]] TableRocks::Limit limit(const std::string& place) const {
    if (at(place) == "all") return std::nullopt;
    if (at(place) == "none") return 0;
    return count(place);
  }

 private:
  [[nodiscard]] Json::json_pointer within(const std::string& place) const {
    return Json::json_pointer(place.substr(beginning_.size()));
  }
  const Json& of_kind(const std::string& place, bool is, const char* expected) const {
    const Json& value = at(place);
    if (!is) refuse(place, fmt::format("is of type {}", value.type_name()), fmt::format("expected {}", expected));
    return value;
  }
  [[noreturn]] void refuse(const std::string& place, std::string what, std::string why) const {
    refuse_json_file(file_, place.substr(1), std::move(what), std::move(why), hint);
  }

  std::filesystem::path file_;
  Json json_;
  std::string beginning_;
};

DesignValues design_values(const Values& values, const std::string& statistics) {
  return {.percentile_95 = values.number_if_any(statistics + "/percentiles/95"),
          .percentile_99 = values.number_if_any(statistics + "/percentiles/99"),
          .greatest = values.number_if_any(statistics + "/maximum")};
}

/// Where the project has the barriers of each name.
class BarriersOfProject {
 public:
  explicit BarriersOfProject(const Values& values) : values_(values) {}

  std::string place(const BarrierFacts& barrier) {
    const std::string list = "/project/" + barrier.kind;
    const auto [kind, is_new] = numbers_.try_emplace(barrier.kind);
    if (is_new) {
      for (std::size_t k = 0; k < values_.list(list).size(); ++k) {
        kind->second.emplace(values_.text(fmt::format("{}/{}/name", list, k)), k);
      }
    }
    const auto found = kind->second.find(barrier.name);
    if (found == kind->second.end()) return list + "/" + barrier.name;  // is refused as missing
    return fmt::format("{}/{}", list, found->second);
  }

 private:
  const Values& values_;
  std::map<std::string, std::unordered_map<std::string, std::size_t>> numbers_;  // by kind and name
};

/// As the summary says; where it does not, as far as along the foot.
std::vector<double> stations(const Values& values, const std::string& place,
                             const std::vector<std::array<double, 3>>& foot) {
  const std::string list = place + "/stations_m";
  if (!values.has(list) || values.list(list).size() != foot.size()) return stations_along(foot);
  std::vector<double> stations;
  for (std::size_t k = 0; k < foot.size(); ++k) stations.push_back(values.number(fmt::format("{}/{}", list, k)));
  return stations;
}

/// What the list of barriers says of one.
BarrierFacts barrier_facts(const Values& values, const std::string& place) {
  BarrierFacts facts;
  facts.name = values.text(place + "/name");
  facts.kind = values.text(place + "/kind");
  for (std::size_t k = 0; k < values.list(place + "/line_xyz").size(); ++k) {
    const std::string point = fmt::format("{}/line_xyz/{}", place, k);
    facts.foot_m.push_back({values.number(point + "/0"), values.number(point + "/1"), values.number(point + "/2")});
  }
  facts.stations_m = stations(values, place, facts.foot_m);
  facts.hits = values.count(place + "/hits");
  facts.rocks_hit = values.count(place + "/rocks_hit");
  facts.passed_above = values.count(place + "/passed_above");
  facts.stopped = values.count(place + "/outcomes/stopped");
  facts.rebounded = values.count(place + "/outcomes/rebounded");
  facts.broke_through = values.count(place + "/outcomes/broke through");
  facts.passed = values.count(place + "/outcomes/passed");
  facts.least_clearance_m = values.number_if_any(place + "/least_clearance_m");
  if (facts.hits == 0) return facts;
  facts.ke_total_J = design_values(values, place + "/statistics/ke_total_J");
  facts.ke_translational_J = design_values(values, place + "/statistics/ke_translational_J");
  facts.impact_height_m = design_values(values, place + "/statistics/impact_height_m");
  facts.velocity_m_s = design_values(values, place + "/statistics/velocity_m_s");
  return facts;
}

/// What the project says of it.
void add_given(const Values& values, BarriersOfProject& project, BarrierFacts& facts) {
  const std::string given = project.place(facts);
  facts.height_m = values.number(given + "/height_m");
  facts.inclination_deg = values.number(given + "/inclination_deg");
  if (facts.kind == "barrier" && values.at(given + "/capacity_kJ") != "inf") {
    facts.capacity_kJ = values.number(given + "/capacity_kJ");
  }
}

std::vector<SourceStretch> source_stretches(const Values& values) {
  std::vector<SourceStretch> stretches;
  for (std::size_t k = 0; k < values.list("/sources").size(); ++k) {
    const std::string place = fmt::format("/sources/{}", k), name = values.text(place + "/name");
    for (std::size_t n = 0; n < values.list(place + "/rocks").size(); ++n) {
      const std::string stretch = fmt::format("{}/rocks/{}", place, n);
      stretches.push_back({values.count(stretch + "/0"), values.count(stretch + "/1"), name});
    }
  }
  std::ranges::sort(stretches, {}, &SourceStretch::first_rock);
  return stretches;
}

/// The names of the figures of a section, and where in it they stand.
std::vector<std::pair<std::string, std::string>> design_figures(const Values& values) {
  std::vector<std::pair<std::string, std::string>> figures;
  constexpr std::array<std::pair<const char*, const char*>, 4> quantities{
      {{"ke_translational", "J"}, {"ke_total", "J"}, {"velocity", "m_s"}, {"height", "m"}}};
  for (const auto& [quantity, unit] : quantities) {
    for (std::size_t k = 0; k < values.list("/project/design/percentiles").size(); ++k) {
      const std::string percentile = fmt::format("{}", values.number(fmt::format("/project/design/percentiles/{}", k)));
      figures.emplace_back(fmt::format("{}_p{}_{}", quantity, percentile, unit),
                           fmt::format("/percentiles/{}_{}/{}/0", quantity, unit, percentile));
    }
  }
  for (const char* need : {"energy_J", "class", "height_m"}) {
    figures.emplace_back(fmt::format("needs_{}", need), fmt::format("/needs/{}", need));
  }
  return figures;
}

void read_design(const Values& values, RunFacts& facts) {
  const auto figures = design_figures(values);
  for (const auto& [name, place] : figures) facts.design_figures.push_back(name);
  for (std::size_t k = 0; k < values.list("/design/lines").size(); ++k) {
    const std::string line = fmt::format("/design/lines/{}", k), name = values.text(line + "/name");
    const auto barrier = std::ranges::find(facts.barriers, name, &BarrierFacts::name);
    for (std::size_t s = 0; s < values.list(line + "/sections").size(); ++s) {
      const std::string place = fmt::format("{}/sections/{}", line, s);
      DesignSection& section = facts.design_sections.emplace_back();
      section.line = name;
      section.number = s + 1;
      section.from_m = values.number(place + "/from_m");
      section.to_m = values.number(place + "/to_m");
      if (barrier != facts.barriers.end())
        section.foot_m = stretch_of(barrier->foot_m, barrier->stations_m, section.from_m, section.to_m);
      section.rocks = values.count(place + "/rocks");
      if (values.has(place + "/share/value")) section.share = values.number(place + "/share/value");
      for (const auto& [figure, where] : figures) {
        const std::string at = place + where;
        section.figures.push_back(values.has(at) ? std::optional(values.number(at)) : std::nullopt);
      }
    }
  }
}

}  // namespace

const std::string& RunFacts::source_of(std::uint64_t rock) const {
  static const std::string unknown;
  const auto after = std::ranges::upper_bound(sources, rock, {}, &SourceStretch::first_rock);
  if (after == sources.begin()) return unknown;
  const SourceStretch& stretch = *std::prev(after);
  return rock - stretch.first_rock < stretch.rocks ? stretch.source : unknown;
}

RunFacts read_run_facts(const std::filesystem::path& folder, const char* summary) {
  const std::filesystem::path file = folder / summary;
  RunFacts facts;
  const auto add_barrier = [&](Json barrier) {
    const std::string place = fmt::format("/barriers/{}", facts.barriers.size());
    facts.barriers.push_back(barrier_facts(Values(file, std::move(barrier), place), place));
  };
  Json json = parse_without_list<Json>(text_of_json_file(file, hint, most_json_bytes), "barriers", add_barrier);
  if (!json.is_object()) refuse_json_file(file, "", "is damaged", "it holds no JSON object", hint);
  const Values values(file, std::move(json));
  facts.is_section = values.text("/terrain/kind") == "section";
  if (values.has("/terrain/crs_wkt")) facts.crs_wkt = values.text("/terrain/crs_wkt");
  facts.planned_rocks = values.count("/rocks/planned");
  for (std::size_t k = 0; k < 3 && values.has("/origin_m"); ++k) {
    facts.origin_m[k] = values.number(fmt::format("/origin_m/{}", k));
  }
  // (A run that says nothing of end points wrote all.)
  const char* endpoints = "/project/output/endpoints";
  facts.in_tables = TableRocks(facts.planned_rocks, values.has(endpoints) ? values.limit(endpoints) : std::nullopt,
                               values.limit("/project/output/paths"));
  facts.geopackage_rocks = values.limit("/project/output/geopackage").value_or(facts.planned_rocks);
  facts.wants_geopackage = !facts.is_section && facts.geopackage_rocks > 0;
  facts.wants_vtk = values.flag("/project/output/vtk");
  BarriersOfProject project(values);
  (void)values.list("/barriers");  // whose entries were taken
  for (BarrierFacts& barrier : facts.barriers) add_given(values, project, barrier);
  facts.sources = source_stretches(values);
  if (values.has("/design")) read_design(values, facts);
  return facts;
}

}  // namespace talus::io
