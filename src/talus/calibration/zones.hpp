#pragma once
// Deposits by zone: how much came to rest in each of several areas, observed and simulated.
//
// A sample of zones has a row for each rock: the number of its zone, and its amount, which is its volume [m3], or 1 if
// rocks were counted. What came to rest outside all zones has the number after the last zone, if it was observed.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "talus/calibration/redraw.hpp"
#include "talus/calibration/study.hpp"
#include "talus/meshing/plan_polygon.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::calibration {

struct ObservedZone {
  std::string name;
  double amount = 0;                        // [m3], rocks, or a share
  std::vector<PlanPolygon> polygons;        // 3D
  std::vector<std::vector<Vec2>> outlines;  // of the polygons, without their holes
  double from = 0, to = 0;                  // of a section [m]

  [[nodiscard]] bool contains(const Vec2& place) const;
};

enum class ZoneAmount { volume, count, share };

struct ObservedZones {
  std::vector<ObservedZone> list;
  ZoneAmount amount = ZoneAmount::volume;
  bool has_elsewhere = false;  // what lies outside all zones was observed, too: `released` or shares
  double total = 0;            // in all zones
  std::optional<double> released;
  double relative_accuracy = 0;  // standard deviation of the error of an observed amount over the amount

  [[nodiscard]] std::size_t category_count() const { return list.size() + (has_elsewhere ? 1 : 0); }
  /// The category of a place; category_count() if none.
  [[nodiscard]] std::size_t of(const Vec2& place) const;
  [[nodiscard]] std::string name_of(std::size_t category) const;
  /// "m3", "rocks" or "".
  [[nodiscard]] std::string unit() const;
  /// The amount of a simulated rock.
  [[nodiscard]] double amount_of(const study::RockEnd& end) const;
};

struct ReadZones {
  ObservedZones zones;
  Sample sample;  // each zone's amount, divided among as many rocks as were counted, or would make it up
};

/// Reads the zones of `from.zones`: a table or polygons. `ends`: of the project's own values, whose volumes say how
/// many rocks an observed volume is. Throws BadInput with all problems; doubts are added to `warnings`.
[[nodiscard]] ReadZones read_zones(const Study& study, const StudyObservations& from, const study::PreparedSite& site,
                                   const std::vector<study::RockEnd>& ends, Problems& warnings);

[[nodiscard]] Sample zone_sample(const ObservedZones& zones, const std::vector<study::RockEnd>& ends);

/// The share of each category in the amounts of these rows; they add up to 1. Expects one row or more.
[[nodiscard]] Eigen::VectorXd zone_shares(const ObservedZones& zones, const Sample& sample);
/// How many rocks of equal amounts would vary as much: the square of the sum over the sum of the squares.
[[nodiscard]] double effective_rocks(const Sample& sample);
/// The same of observed rocks, whose amounts have errors: the number of rocks, counted without error, whose shares vary
/// as much in all (to first order in the errors).
[[nodiscard]] double effective_rocks(const ObservedZones& zones, const Sample& observed);

}  // namespace talus::calibration
