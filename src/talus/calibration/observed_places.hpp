#pragma once
// Files of observed places: where rocks came to rest or struck the ground.

#include <optional>
#include <string>
#include <vector>

#include "talus/calibration/study.hpp"
#include "talus/core/problems.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::calibration {

struct ObservedPlace {
  Vec3 position;  // [m]; z is 0 if it was not observed
  bool has_z = false;
  std::string release;         // as written; empty: not known
  std::string rock;            // of marks; empty: not known
  std::optional<double> mass;  // [kg]
  Problem place;               // of the row, for messages
};

/// Reads the places of `from.stops` or `from.marks`: a table with the columns x_m, y_m, z_m, release, rock and mass_kg,
/// or points with the attributes release, rock and mass_kg. Throws BadInput with all problems; doubts are added to
/// `warnings`.
[[nodiscard]] std::vector<ObservedPlace> read_places(const Study& study, const StudyObservations& from,
                                                     const study::PreparedSite& site, Problems& warnings);

/// The elevation of the terrain at a place on plan; nullopt: off the terrain.
[[nodiscard]] std::optional<double> elevation_at(const study::PreparedSite& site, const Vec2& place);
/// Of the terrain on plan, for messages.
[[nodiscard]] std::string extent_of(const study::PreparedSite& site);
/// Whether a file is read as a text table.
[[nodiscard]] bool is_text_table(const std::filesystem::path& file);

}  // namespace talus::calibration
