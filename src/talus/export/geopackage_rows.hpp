#pragma once
// The columns of the layers of results.gpkg; those of the layer `endpoints` are EndpointRow's and `source`.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "talus/archive/table_columns.hpp"

namespace talus {

/// Of the layers `paths` and `releases`: a rock, as endpoints.csv has it.
struct RockLayerRow {
  std::uint64_t rock = 0;
  std::string seeder{}, source{};
  EndReason end_reason = EndReason::at_rest;
  double time_s = 0;
  std::uint64_t events = 0;
  double runout_xy_m = 0, mass_kg = 0, radius_m = 0, max_ke_J = 0, max_bounce_m = 0;

  static constexpr auto columns() {
    using R = RockLayerRow;
    return std::tuple(
        key("rock", "number of the rock", &R::rock), word("seeder", "name of its seeder", &R::seeder),
        word("source", "its source area", &R::source), word("end_reason", "as in `endpoints.csv`", &R::end_reason),
        quantity("time_s", "s", "the same", &R::time_s), quantity("events", "", "the same", &R::events),
        quantity("runout_xy_m", "m", "the same", &R::runout_xy_m), quantity("mass_kg", "kg", "the same", &R::mass_kg),
        quantity("radius_m", "m", "the same", &R::radius_m), quantity("max_ke_J", "J", "the same", &R::max_ke_J),
        quantity("max_bounce_m", "m", "the same", &R::max_bounce_m));
  }
};

/// A quantity of hits of which a barrier has percentiles and the maximum.
struct HitQuantity {
  std::string_view name, unit_in_name, unit, meaning;
};
inline constexpr std::array<HitQuantity, 4> hit_quantities{
    {{"ke_total", "J", "J", "total kinetic energy of the hits"},
     {"ke_translational", "J", "J", "translational kinetic energy of the hits"},
     {"impact_height", "m", "m", "impact height of the contact"},
     {"velocity", "m_s", "m/s", "velocity of the hits"}}};

/// Of the layer `barriers`: a barrier or collector.
struct BarrierLayerRow {
  std::string name{}, kind{};
  double height_m = 0, inclination_deg = 0;
  std::optional<double> capacity_kJ{};
  std::uint64_t hits = 0, rocks_hit = 0, passed_above = 0, stopped = 0, rebounded = 0, broke_through = 0, passed = 0;
  std::optional<double> least_clearance_m{};
  FamilyValues statistics{};  // by hit_quantities: percentiles 95 and 99, maximum

  static constexpr auto columns() {
    using R = BarrierLayerRow;
    return std::tuple(
        word("name", "its name", &R::name), word("kind", "`barrier` or `collector`", &R::kind),
        quantity("height_m", "m", "height", &R::height_m),
        quantity("inclination_deg", "°", "inclination", &R::inclination_deg),
        quantity("capacity_kJ", "kJ", "capacity; null: a collector, or without limit", &R::capacity_kJ),
        quantity("hits", "", "hits", &R::hits), quantity("rocks_hit", "", "rocks that hit it", &R::rocks_hit),
        quantity("passed_above", "", "rocks that passed above it", &R::passed_above),
        quantity("stopped", "", "hits with this outcome", &R::stopped),
        quantity("rebounded", "", "the same", &R::rebounded),
        quantity("broke_through", "", "the same", &R::broke_through), quantity("passed", "", "the same", &R::passed),
        quantity("least_clearance_m", "m", "minimum clearance of the rocks that passed above it",
                 &R::least_clearance_m),
        family(&R::statistics));
  }
  /// "ke_total_p95_J"; `part` is p95, p99 or max.
  [[nodiscard]] static std::string column(const HitQuantity& quantity, std::string_view part);
  [[nodiscard]] static std::vector<ColumnText> family_texts();
};

/// Of the layer `design`: a section of a line.
struct DesignLayerRow {
  std::string line{};
  std::uint64_t section = 0;
  double from_m = 0, to_m = 0;
  std::uint64_t rocks = 0;
  std::optional<double> share{};
  FamilyValues figures{};  // named by RunFacts::design_figures

  static constexpr auto columns() {
    using R = DesignLayerRow;
    return std::tuple(word("line", "name of the barrier or collector", &R::line),
                      key("section", "number of the section, from 1", &R::section),
                      quantity("from_m", "m", "where it begins along the line on plan", &R::from_m),
                      quantity("to_m", "m", "where it ends", &R::to_m),
                      quantity("rocks", "", "rocks that cross it first of all sections", &R::rocks),
                      quantity("share", "", "share of all rocks of the run", &R::share), family(&R::figures));
  }
  [[nodiscard]] static std::vector<ColumnText> family_texts();
};

}  // namespace talus
