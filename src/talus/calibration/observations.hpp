#pragma once
// What was observed at a site, and the same quantities of simulated rocks.

#include <optional>
#include <string>
#include <vector>

#include "talus/calibration/likelihood.hpp"
#include "talus/calibration/releases.hpp"
#include "talus/calibration/study.hpp"
#include "talus/calibration/zones.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::calibration {

/// How places on plan become distances: along the line from the releases towards the simulated stops, and to its left.
struct PlanAxis {
  Vec2 origin;       // mean of the releases [m]
  Vec2 along{1, 0};  // unit
  [[nodiscard]] Vec2 of(const Vec2& p) const {
    const Vec2 way = p - origin;
    return {along.dot(way), along.x() * way.y() - along.y() * way.x()};
  }
};

enum class ObservationKind { stops, marks, values, zones };
enum class LineValue { height, velocity, energy };

/// Observations of one file.
struct ObservedGroup {
  std::string name;
  std::size_t site = 0;  // of the study
  ObservationKind kind = ObservationKind::stops;
  std::vector<Feature> features;  // of stops and marks: runout, lateral; of values: those of the file; of zones: none
  /// Strata: the releases, if the file names them, or classes of mass. Rocks: those that left the marks, if it names
  /// them. Of zones: the zone and the volume of each rock (zones.hpp).
  Sample sample;
  double weight = 1;

  PlanAxis axis;                  // of stops and marks
  ReleaseStrata releases;         // of stops and marks
  BarrierId barrier;              // of values
  std::vector<LineValue> values;  // of values, by feature
  ObservedZones zones;            // of zones

  /// Runout and lateral position of a place of a rock of this release.
  [[nodiscard]] Vec2 place_of(const Vec3& position, std::uint32_t stratum) const;
  /// Independent observations: rocks.
  [[nodiscard]] std::size_t count() const { return sample.first_rows().size() - 1; }
};

/// Reads the observations of one entry of the study. Throws BadInput with all problems; doubts are added to `warnings`.
[[nodiscard]] ObservedGroup read_observations(const Study& study, const StudyObservations& from, std::size_t site,
                                              const study::PreparedSite& prepared, Problems& warnings);

/// The simulated values of a group's features, a row for each rock that has them: all rocks for stops, or those of
/// observed releases; the rocks that arrive for values; all rocks for zones. For marks, a row for each impact: the
/// outcome must have its marks.
[[nodiscard]] Sample simulated_sample(const ObservedGroup& group, const study::SetOutcome& outcome);

}  // namespace talus::calibration
