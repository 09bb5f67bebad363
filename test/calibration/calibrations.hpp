#pragma once
// A study of a slope with observed stops, values at the road and impact marks, all of known parameters.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "calibration/slope.hpp"
#include "support/input_folder.hpp"
#include "talus/calibration/calibrate.hpp"
#include "talus/core/random.hpp"
#include "talus/project/read.hpp"

namespace talus::calibration {

class Calibrations : public testing_tools::InputFolder {
 protected:
  static inline const std::string slope = scree_slope + cliff_release + road_collector;
  static inline const std::string study_text = R"(
rocks = 80
draws = 240
folds = 3
[[site]]
project = "slope.toml"
[[observations]]
stops = "stops.csv"
[[parameter]]
path = "material.Scree.tangential_restitution"
range = [0.6, 0.9]
[[parameter]]
path = "material.Scree.roughness_deg"
range = [1, 12]
)";

  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
  }

  Calibrations() {
    write("slope.toml", slope);
    write("study.toml", study_text);
  }

  /// Observed stops of this many rocks with these values, and their arrivals at the road.
  void observe(int rocks, double tangential, double roughness, std::uint64_t seed) {
    project::Reading reading =
        project::read_project_text(slope, "slope.toml",
                                   {{"material.Scree.tangential_restitution.mean=" + std::to_string(tangential),
                                     "material.Scree.roughness_deg=" + std::to_string(roughness)},
                                    rocks,
                                    seed});
    const study::PreparedSite site(std::move(reading.project), warnings_);
    const study::SetOutcome outcome = site.run({}, {}, {.keep_marks = true});
    std::string stops = "x_m\n", marks = "x_m\n", values = "velocity_m_s,energy_kJ\n";
    for (const study::RockEnd& end : outcome.ends) {
      const auto [a, b] = uniform_pair(seed, end.rock, static_cast<Stream>(6000), 0);
      const double error = 0.5 * std::sqrt(-2 * std::log(a)) * std::cos(2 * 3.141592653589793 * b);
      stops += std::to_string(end.end.x() + error) + "\n";
    }
    for (const study::Crossing& crossing : outcome.crossings)
      values += std::to_string(crossing.speed) + "," +
                std::to_string((crossing.translational_energy + crossing.rotational_energy) / 1000) + "\n";
    write("stops.csv", stops);
    for (const study::Mark& mark : outcome.marks) {
      if (mark.rock % 4 == 0) marks += std::to_string(mark.position.x()) + "\n";
    }
    write("values.csv", values);
    write("marks.csv", marks);
  }

  PreparedStudy prepared() {
    warnings_ = {};
    return {read_study(path("study.toml")).study, nullptr, warnings_};
  }

  static bool holds(const CalibrationResult& result, std::size_t parameter, double truth) {
    std::vector<double> values, weights;
    for (const SetResult& set : result.sets) {
      values.push_back(set.values[parameter]);
      weights.push_back(set.weight);
    }
    return weighted_quantile(values, weights, 0.05) <= truth && truth <= weighted_quantile(values, weights, 0.95);
  }
};

}  // namespace talus::calibration
