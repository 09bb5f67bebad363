#include "talus/archive/run_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "talus/archive/design_tables.hpp"
#include "talus/archive/foot_stretch.hpp"

namespace talus {

namespace {

/// "all" (nullopt), "none" (0) or a number of rocks.
struct RockLimit {
  TableRocks::Limit most{};
  static RockLimit from(const JsonValue& json, const JsonPlace& place) {
    if (json == "all") return {};
    if (json == "none") return {0};
    expect_kind(json.is_number_unsigned(), json, place, "a whole number, 0 or more");
    return {json.get<std::uint64_t>()};
  }
};

/// A number, or "inf" (nullopt).
struct Capacity {
  std::optional<double> kJ{};
  static Capacity from(const JsonValue& json, const JsonPlace& place) {
    if (json == "inf") return {};
    expect_kind(json.is_number(), json, place, "a number");
    return {json.get<double>()};
  }
};

// The needed parts of the project in the summary.

struct GivenBarrier {  // or collector, which has no capacity
  std::string name{};
  double height_m = 0, inclination_deg = 0;
  Capacity capacity_kJ{};
  static auto fields() {
    using B = GivenBarrier;
    return std::tuple(field("name", &B::name), field("height_m", &B::height_m),
                      field("inclination_deg", &B::inclination_deg), field_if_any("capacity_kJ", &B::capacity_kJ));
  }
};
struct GivenDesign {
  std::vector<double> percentiles{};
  static auto fields() { return std::tuple(field("percentiles", &GivenDesign::percentiles)); }
};
struct GivenOutput {
  RockLimit endpoints{}, paths{}, impacts{0}, geopackage{};
  bool vtk = false;
  static auto fields() {
    using O = GivenOutput;
    return std::tuple(field("endpoints", &O::endpoints), field("paths", &O::paths),
                      field_if_any("impacts", &O::impacts), field("geopackage", &O::geopackage), field("vtk", &O::vtk));
  }
};
struct GivenProject {
  std::vector<GivenBarrier> barriers{}, collectors{};
  std::optional<GivenDesign> design{};
  GivenOutput output{};
  static auto fields() {
    using P = GivenProject;
    return std::tuple(field_if_any("barrier", &P::barriers), field_if_any("collector", &P::collectors),
                      field_if_any("design", &P::design), field("output", &P::output));
  }
};

// The needed parts of the design.

struct Share {
  double value = 0;
  static auto fields() { return std::tuple(field("value", &Share::value)); }
};
struct Needs {
  double energy_J = 0, kit_class = 0, height_m = 0;
  static auto fields() {
    return std::tuple(field("energy_J", &Needs::energy_J), field("class", &Needs::kit_class),
                      field("height_m", &Needs::height_m));
  }
};
struct SectionFigures {
  double from_m = 0, to_m = 0;
  std::uint64_t rocks = 0;
  std::optional<Share> share{};
  Named<Named<std::array<std::optional<double>, 3>>> percentiles{};  // by quantity and percentile: value, low, high
  std::optional<Needs> needs{};
  static auto fields() {
    using F = SectionFigures;
    return std::tuple(field("from_m", &F::from_m), field("to_m", &F::to_m), field("rocks", &F::rocks),
                      field("share", &F::share), field("percentiles", &F::percentiles), field("needs", &F::needs));
  }
};
struct DesignedLine {
  std::string name{};
  std::vector<SectionFigures> sections{};
  static auto fields() {
    return std::tuple(field("name", &DesignedLine::name), field("sections", &DesignedLine::sections));
  }
};
struct DesignedLines {
  std::vector<DesignedLine> lines{};
  static auto fields() { return std::tuple(field("lines", &DesignedLines::lines)); }
};

/// The settings of barriers and collectors by name.
class GivenByName {
 public:
  explicit GivenByName(const GivenProject& project) {
    for (const GivenBarrier& given : project.barriers) barriers_.emplace(given.name, &given);
    for (const GivenBarrier& given : project.collectors) collectors_.emplace(given.name, &given);
  }

  void add_to(BarrierFacts& facts) const {
    const auto& known = facts.kind == "barrier" ? barriers_ : collectors_;
    const auto found = known.find(facts.name);
    if (found == known.end())
      throw BadField{fmt::format("project/{}/{}", facts.kind, facts.name), "is missing", "a run writes it"};
    facts.height_m = found->second->height_m;
    facts.inclination_deg = found->second->inclination_deg;
    facts.capacity_kJ = found->second->capacity_kJ.kJ;
  }

 private:
  std::unordered_map<std::string_view, const GivenBarrier*> barriers_, collectors_;
};

/// The figures of a section, in the order of RunFacts::design_figures.
std::vector<std::optional<double>> figures_of(const SectionFigures& section, const GivenDesign& design) {
  std::vector<std::optional<double>> figures;
  for (const DesignQuantity& quantity : design_quantities) {
    const auto* const known = find_named(section.percentiles, key_of(quantity));
    for (const double percentile : design.percentiles) {
      const auto* const ends = known == nullptr ? nullptr : find_named(*known, fmt::format("{}", percentile));
      figures.push_back(ends == nullptr ? std::nullopt : (*ends)[0]);
    }
  }
  const auto need = [&](double Needs::*member) {
    figures.push_back(section.needs ? std::optional((*section.needs).*member) : std::nullopt);
  };
  need(&Needs::energy_J);
  need(&Needs::kit_class);
  need(&Needs::height_m);
  return figures;
}

void add_design(const GivenDesign& design, RunFacts& facts) {
  for (const DesignQuantity& quantity : design_quantities) {
    for (const double percentile : design.percentiles)
      facts.design_figures.push_back(design_column(quantity, fmt::format("{}", percentile)));
  }
  for (const char* need : {"energy_J", "class", "height_m"})
    facts.design_figures.push_back(fmt::format("needs_{}", need));
  for (const DesignedLine& line : part_of<DesignedLines>(*facts.summary.design, "design").lines) {
    const auto barrier = std::ranges::find(facts.barriers, line.name, &BarrierFacts::name);
    for (std::size_t k = 0; k < line.sections.size(); ++k) {
      const SectionFigures& figures = line.sections[k];
      DesignSection& section = facts.design_sections.emplace_back();
      section.line = line.name;
      section.number = k + 1;
      section.from_m = figures.from_m;
      section.to_m = figures.to_m;
      if (barrier != facts.barriers.end())
        section.foot_m = stretch_of(barrier->line_xyz, barrier->stations, section.from_m, section.to_m);
      section.rocks = figures.rocks;
      if (figures.share) section.share = figures.share->value;
      section.figures = figures_of(figures, design);
    }
  }
}

/// Derives all other facts from the summary. Throws BadField.
void complete(RunFacts& facts) {
  const RunSummary& summary = facts.summary;
  const auto project = part_of<GivenProject>(*summary.project, "project");
  facts.is_section = summary.terrain.kind == "section";
  facts.in_tables = TableRocks(summary.rocks.planned, {.endpoints = project.output.endpoints.most,
                                                       .paths = project.output.paths.most,
                                                       .impacts = project.output.impacts.most});
  facts.geopackage_rocks = project.output.geopackage.most.value_or(summary.rocks.planned);
  facts.wants_geopackage = !facts.is_section && facts.geopackage_rocks > 0;
  facts.wants_vtk = project.output.vtk;
  const GivenByName given(project);
  for (BarrierFacts& barrier : facts.barriers) given.add_to(barrier);
  if (summary.design) add_design(project.design.value_or(GivenDesign{}), facts);
}

}  // namespace

const std::string& RunFacts::source_of(std::uint64_t rock) const {
  static const std::string unknown;
  const auto after =
      std::ranges::upper_bound(summary.releases, rock, {}, [](const SeederReleases& of) { return of.first_rock; });
  if (after == summary.releases.begin()) return unknown;
  const SeederReleases& of = *std::prev(after);
  return rock - of.first_rock < of.rocks ? summary.sources[of.source_of(rock)].name : unknown;
}

RunFacts read_run_facts(const std::filesystem::path& folder, const char* summary) {
  const std::filesystem::path file = folder / summary;
  RunFacts facts;
  facts.summary = read_run_summary(file, [&](BarrierSummary barrier) {
    BarrierFacts& known = facts.barriers.emplace_back(BarrierFacts{std::move(barrier)});
    const bool has_stations = known.stations_m.size() == known.line_xyz.size();
    known.stations = has_stations ? std::move(known.stations_m) : stations_along(known.line_xyz);
  });
  try {
    complete(facts);
  } catch (const BadField& bad) {
    refuse_summary(file, bad);
  }
  return facts;
}

}  // namespace talus
