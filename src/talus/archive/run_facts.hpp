#pragma once
// What those need of summary.json who make other files of a run's tables: its parts brought together.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/archive/table_rocks.hpp"

namespace talus {

/// What rocks did at a barrier, and what the project says of it.
struct BarrierFacts : BarrierSummary {
  std::vector<double> stations{};  // of each point of the foot, along the line as it was given, on plan [m]
  double height_m = 0, inclination_deg = 0;
  std::optional<double> capacity_kJ{};  // nothing: of a collector, or without limit
};

/// A section of a line along which a barrier is designed.
struct DesignSection {
  std::string line;
  std::uint64_t number = 0;  // from 1
  double from_m = 0, to_m = 0;
  std::vector<std::array<double, 3>> foot_m;
  std::uint64_t rocks = 0;
  std::optional<double> share;                 // of all rocks
  std::vector<std::optional<double>> figures;  // in the order of RunFacts::design_figures
};

/// Rocks one after the other that come from one source.
struct SourceStretch {
  std::uint64_t first_rock = 0, rocks = 0;
  std::string source;
};

struct RunFacts {
  RunSummary summary;  // but for its barriers
  bool is_section = false;
  TableRocks in_tables{0};             // rocks that the tables hold, if they were done
  std::uint64_t geopackage_rocks = 0;  // of how many of them results.gpkg is to hold the ends, or the paths
  bool wants_geopackage = false, wants_vtk = false;
  std::vector<BarrierFacts> barriers;
  std::vector<SourceStretch> sources;  // in the order of the rocks
  /// What is known of each section, named as the columns of design.csv: percentiles, and what the check asks for.
  std::vector<std::string> design_figures;
  std::vector<DesignSection> design_sections;  // empty where no barrier is designed

  [[nodiscard]] std::uint64_t planned_rocks() const { return summary.rocks.planned; }  // of the whole campaign
  /// The source of a rock; empty where the summary does not say.
  [[nodiscard]] const std::string& source_of(std::uint64_t rock) const;
};

/// Reads FOLDER/summary.json, or what is to become it. Throws BadInput where it is none, or not as a run writes
/// it.
[[nodiscard]] RunFacts read_run_facts(const std::filesystem::path& folder, const char* summary = "summary.json");

}  // namespace talus
