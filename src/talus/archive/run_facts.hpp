#pragma once
// The facts of summary.json that are needed to make other files from the tables of a run.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/archive/table_rocks.hpp"

namespace talus {

/// A barrier: its results, and its settings in the project.
struct BarrierFacts : BarrierSummary {
  std::vector<double> stations{};  // of each point of the foot along the line of the input, on plan [m]
  double height_m = 0, inclination_deg = 0;
  std::optional<double> capacity_kJ{};  // nullopt: a collector, or without limit
};

/// A section of a line along which a barrier is designed.
struct DesignSection {
  std::string line;
  std::uint64_t number = 0;  // from 1
  double from_m = 0, to_m = 0;
  std::vector<std::array<double, 3>> foot_m;
  std::uint64_t rocks = 0;
  std::optional<double> share;                 // of all rocks
  std::vector<std::optional<double>> figures;  // by RunFacts::design_figures
};

struct RunFacts {
  RunSummary summary;  // without its barriers
  bool is_section = false;
  TableRocks in_tables{0, {}};         // rocks in the tables, if they were done
  std::uint64_t geopackage_rocks = 0;  // number of end points, and of paths, in results.gpkg
  bool wants_geopackage = false, wants_vtk = false;
  std::vector<BarrierFacts> barriers;
  /// Names of the figures of a section, as columns of the layer `design`: percentiles, and the demands of the check.
  std::vector<std::string> design_figures;
  std::vector<DesignSection> design_sections;  // empty without a design

  [[nodiscard]] std::uint64_t planned_rocks() const { return summary.rocks.planned; }  // of the whole campaign
  /// The source of a rock; empty if the summary has none.
  [[nodiscard]] const std::string& source_of(std::uint64_t rock) const;
};

/// Reads FOLDER/summary.json, or the file that will become it. Throws BadInput if it is missing or not as a run writes
/// it.
[[nodiscard]] RunFacts read_run_facts(const std::filesystem::path& folder, const char* summary = "summary.json");

}  // namespace talus
