#pragma once
// What summary.json says of a run that those need who make other files of its tables.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/table_rocks.hpp"

namespace talus::io {

/// Of all hits on a barrier; nothing without any.
struct DesignValues {
  std::optional<double> percentile_95, percentile_99, greatest;
};

struct BarrierFacts {
  std::string name, kind;  // "barrier" or "collector"
  std::vector<std::array<double, 3>> foot_m;
  std::vector<double> stations_m;  // of each point of the foot, along the line as it was given, on plan
  double height_m = 0, inclination_deg = 0;
  std::optional<double> capacity_kJ;  // nothing: of a collector, or without limit
  std::uint64_t hits = 0, rocks_hit = 0, passed_above = 0;
  std::uint64_t stopped = 0, rebounded = 0, broke_through = 0, passed = 0;  // hits by outcome
  std::optional<double> least_clearance_m;
  DesignValues ke_total_J, ke_translational_J, impact_height_m, velocity_m_s;
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
  bool is_section = false;
  std::string crs_wkt;                 // empty: not known
  std::uint64_t planned_rocks = 0;     // of the whole campaign
  std::array<double, 3> origin_m{};    // next to which positions are counted
  TableRocks in_tables{0};             // rocks that the tables hold, if they were done
  std::uint64_t geopackage_rocks = 0;  // of how many of them results.gpkg is to hold the ends, or the paths
  bool wants_geopackage = false, wants_vtk = false;
  std::vector<BarrierFacts> barriers;
  std::vector<SourceStretch> sources;  // in the order of the rocks
  /// What is known of each section, named as the columns of design.csv: percentiles, and what the check asks for.
  std::vector<std::string> design_figures;
  std::vector<DesignSection> design_sections;  // empty where no barrier is designed

  /// The source of a rock; empty where the summary does not say.
  [[nodiscard]] const std::string& source_of(std::uint64_t rock) const;
};

/// Reads FOLDER/summary.json, or what is to become it. Throws BadInput where it is none, or not as a run writes it.
[[nodiscard]] RunFacts read_run_facts(const std::filesystem::path& folder, const char* summary = "summary.json");

}  // namespace talus::io
