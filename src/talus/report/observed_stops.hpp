#pragma once
// Places where rocks were observed to stop, from a table or a vector file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/core/problems.hpp"

namespace talus {

struct ObservedStop {
  double x_m = 0, y_m = 0;  // in the coordinates of the project; y is 0 in a section
  std::optional<double> z_m;
  std::string name;
  std::optional<double> mass_kg;
  int origin = 0;  // line of the table, or number of the feature
};

struct ObservedStops {
  std::filesystem::path file;
  std::vector<ObservedStop> stops;  // one or more
};

inline constexpr std::size_t most_observed_stops = 5000;

/// Reads a table (`.csv`, `.txt` or `.tsv`) with columns x, y and, if there are any, z, name and mass; in a section
/// without y. Or the points of any other vector file, which are transformed to the coordinate system of the run. Throws
/// BadInput with all problems: places outside the terrain, numbers that are none. Heights that are more than a metre
/// off the terrain are warnings, because they are not compared.
[[nodiscard]] ObservedStops read_observed_stops(const std::filesystem::path& file, const RunSummary& run,
                                                Problems& warnings);

}  // namespace talus
