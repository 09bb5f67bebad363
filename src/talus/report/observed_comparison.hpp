#pragma once
// Observed stops beside the simulated end points of a run, as the report shows them.
//
// In position on plan the distance is the energy distance; along one coordinate (runout, lateral position, x of a
// section) the energy distance and the statistic of Kolmogorov and Smirnov. Each is beside what chance alone gives: the
// same distance of as many rocks that are drawn from the simulated ones (statistics/by_chance.hpp).

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "talus/archive/run_folder.hpp"
#include "talus/report/observed_stops.hpp"

namespace talus {

/// For the page. The simulated rocks are those of `run.endpoints`, wherever they ended.
[[nodiscard]] nlohmann::ordered_json observed_json(const ObservedStops& observed, const RunFolder& run);

/// Its energy distances in words, a line for each quantity.
[[nodiscard]] std::vector<std::string> comparison_lines(const nlohmann::ordered_json& observed);

}  // namespace talus
