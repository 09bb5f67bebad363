#pragma once
// Observed rocks matched with simulated ones: of the same release, or of a similar mass.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/calibration/observed_places.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::calibration {

/// Which simulated rocks an observed one is compared with. Without names and bounds: all of them.
struct ReleaseStrata {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  std::vector<std::string> names;      // of seeders or rows of their tables, by stratum
  std::vector<std::uint32_t> of_rock;  // stratum of each simulated rock; none: its release was not observed
  std::vector<Vec2> origins;           // mean place of release [m], by stratum
  std::vector<double> mass_bounds;     // between classes, ascending [kg]; not together with names

  [[nodiscard]] bool is_one() const { return names.empty() && mass_bounds.empty(); }
  /// For messages.
  [[nodiscard]] std::string name_of(std::uint32_t stratum) const;
  [[nodiscard]] std::uint32_t class_of(double mass) const;
  /// The stratum of a simulated rock.
  [[nodiscard]] std::uint32_t of(const study::RockEnd& end) const;
};

/// Masses in a message: "300 kg", "72.04 to 895 kg".
[[nodiscard]] std::string mass_range(double least, double most);

struct MatchedPlaces {
  ReleaseStrata strata;
  std::vector<std::uint32_t> of_place;  // stratum of each observed place; empty if all are in one
};

/// Matches observed places with the releases that they name, or, if they name none and give masses, with classes of
/// mass: as many as have five observed and twenty simulated rocks each, four at most. `ends`: of the project's own
/// values. Throws BadInput with all problems; doubts are added to `warnings`.
[[nodiscard]] MatchedPlaces match_places(const std::vector<ObservedPlace>& places, const study::PreparedSite& site,
                                         const std::vector<study::RockEnd>& ends, const std::string& file,
                                         Problems& warnings);

}  // namespace talus::calibration
