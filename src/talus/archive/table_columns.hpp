#pragma once
// The rows and columns of endpoints.csv, paths.csv, impacts.csv and barriers.csv, for writers and readers.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "talus/barriers/barrier.hpp"
#include "talus/files/csv_table.hpp"
#include "talus/rocks/motion.hpp"

namespace talus {

template <>
struct Words<PathState> {
  static constexpr std::array values{PathState::projectile, PathState::impact,  PathState::sliding,
                                     PathState::rolling,    PathState::barrier, PathState::ended};
  static constexpr const char* fault = "is not a state";
};
template <>
struct Words<EndReason> {
  static constexpr std::array values{
      EndReason::at_rest,       EndReason::left_model,   EndReason::no_data, EndReason::stopped_by_barrier,
      EndReason::maximum_steps, EndReason::maximum_time, EndReason::lost};
  static_assert(values.size() == end_reason_count);
  static constexpr const char* fault = "is not an end reason";
};
template <>
struct Words<BarrierOutcome> {
  static constexpr std::array values{BarrierOutcome::stopped, BarrierOutcome::rebounded, BarrierOutcome::broke_through,
                                     BarrierOutcome::passed};
  static_assert(values.size() == barrier_outcome_count);
  static constexpr const char* fault = "is not an outcome";
};

inline constexpr std::string_view ensemble_meaning =
    "with `sampling.parameters`: number of the rock's ensemble, from 0; otherwise empty";

/// A row of endpoints.csv: how a rock ended. Positions are in the project's coordinates.
struct EndpointRow {
  static constexpr const char* file_name = "endpoints.csv";
  static constexpr std::size_t may_lack = 4;  // the last columns: only runs with blocks have them

  std::uint64_t rock = 0;
  std::string seeder{};
  std::array<double, 3> position_m{};
  double runout_xy_m = 0, runout_z_m = 0, runout_total_m = 0;
  std::optional<double> lateral_m{};
  double time_s = 0;
  std::uint64_t events = 0;
  EndReason end_reason = EndReason::at_rest;
  std::string ground{};  // empty: it left the model, or there is none
  double mass_kg = 0, radius_m = 0, max_ke_J = 0, max_bounce_m = 0;
  std::optional<std::uint64_t> ensemble{};
  std::optional<double> a_m{}, b_m{}, c_m{}, short_axis_share{};
  [[nodiscard]] bool is_block() const { return a_m.has_value(); }

  static constexpr auto columns() {
    using R = EndpointRow;
    return std::tuple(
        key("rock", "number of the rock, from 0, seeder after seeder", &R::rock),
        word("seeder", "name of its seeder", &R::seeder),
        quantity("x_m", "m", "x of its centre where it ended", &R::position_m, 0),
        quantity("y_m", "m", "y of its centre", &R::position_m, 1),
        quantity("z_m", "m", "z of its centre", &R::position_m, 2),
        quantity("runout_xy_m", "m",
                 "distance from release to end on plan; with `runout_from` or `runout_along`, from that point or along "
                 "that line",
                 &R::runout_xy_m),
        quantity("runout_z_m", "m", "z at the release minus z at the end: positive downwards", &R::runout_z_m),
        quantity("runout_total_m", "m", "straight distance from release to end in space", &R::runout_total_m),
        quantity("lateral_m", "m",
                 "with `runout_along`: distance from the line on plan, positive to its left; otherwise empty",
                 &R::lateral_m),
        quantity("time_s", "s", "time from release to end", &R::time_s),
        quantity("events", "", "number of impacts, hits on barriers and take-offs where the ground falls away or ends",
                 &R::events),
        word("end_reason", "why the trajectory ended", &R::end_reason),
        word("ground", "material of the ground straight below its centre where it ended; empty if it left the model",
             &R::ground),
        quantity("mass_kg", "kg", "mass", &R::mass_kg),
        quantity("radius_m", "m", "radius of the equivalent sphere", &R::radius_m),
        quantity("max_ke_J", "J", "maximum total kinetic energy: translational and rotational", &R::max_ke_J),
        quantity("max_bounce_m", "m",
                 "maximum bounce height: of the block's lowest point above the ground straight below it",
                 &R::max_bounce_m),
        key("ensemble", ensemble_meaning, &R::ensemble),
        quantity("a_m", "m", "runs with blocks: length along its longest principal axis; of spheres empty", &R::a_m),
        quantity("b_m", "m", "along the intermediate one", &R::b_m),
        quantity("c_m", "m", "along the shortest one; in 2D empty, as the next", &R::c_m),
        quantity("short_axis_share", "",
                 "of a block: the part of its angular momentum along its shortest axis, mean over the time of its "
                 "flights: near 1 it rolls as a wheel",
                 &R::short_axis_share));
  }
};

/// A row of paths.csv: a moment of a rock's trajectory.
struct PathEventRow {
  static constexpr const char* file_name = "paths.csv";
  static constexpr std::size_t may_lack = 4;  // as in EndpointRow

  std::uint64_t rock = 0, event = 0;
  PathState state = PathState::projectile;
  double time_s = 0;
  std::array<double, 3> position_m{}, velocity_m_s{}, spin_rad_s{};
  double ke_translational_J = 0, ke_rotational_J = 0, pe_J = 0;
  std::optional<double> qw{}, qx{}, qy{}, qz{};
  [[nodiscard]] double total_J() const { return ke_translational_J + ke_rotational_J + pe_J; }

  static constexpr auto columns() {
    using R = PathEventRow;
    return std::tuple(
        key("rock", "number of the rock", &R::rock), key("event", "number of the row of this rock, from 0", &R::event),
        word("state", "state of the rock from this row on; `impact` and `barrier`: it arrives", &R::state),
        quantity("time_s", "s", "time since the release", &R::time_s),
        quantity("x_m", "m", "x of its centre", &R::position_m, 0),
        quantity("y_m", "m", "y of its centre", &R::position_m, 1),
        quantity("z_m", "m", "z of its centre", &R::position_m, 2),
        quantity("vx_m_s", "m/s", "x of its velocity", &R::velocity_m_s, 0),
        quantity("vy_m_s", "m/s", "y of its velocity", &R::velocity_m_s, 1),
        quantity("vz_m_s", "m/s", "z of its velocity", &R::velocity_m_s, 2),
        quantity("wx_rad_s", "rad/s", "x of its spin, about the axes of the coordinates", &R::spin_rad_s, 0),
        quantity("wy_rad_s", "rad/s", "y of its spin: rolling towards +x is positive", &R::spin_rad_s, 1),
        quantity("wz_rad_s", "rad/s", "z of its spin", &R::spin_rad_s, 2),
        quantity("ke_translational_J", "J", "translational kinetic energy", &R::ke_translational_J),
        quantity("ke_rotational_J", "J", "rotational kinetic energy", &R::ke_rotational_J),
        quantity("pe_J", "J", "potential energy above the datum", &R::pe_J),
        quantity(
            "qw", "",
            "runs with blocks: how it is turned, w, 0 or more, of the quaternion from its principal axes, the longest "
            "along x, to the axes of the coordinates; of spheres empty",
            &R::qw),
        quantity("qx", "", "x of it", &R::qx), quantity("qy", "", "y of it", &R::qy),
        quantity("qz", "", "z of it", &R::qz));
  }
};

/// A row of impacts.csv: a rock strikes the ground.
struct ImpactRow {
  static constexpr const char* file_name = "impacts.csv";

  std::uint64_t rock = 0, impact = 0;
  double time_s = 0;
  std::array<double, 3> position_m{}, velocity_in_m_s{}, spin_in_rad_s{}, velocity_out_m_s{}, spin_out_rad_s{},
      normal{}, struck_normal{};
  std::string ground{};
  std::uint64_t facet = 0;
  double ke_in_J = 0, ke_out_J = 0;

  static constexpr auto columns() {
    using R = ImpactRow;
    return std::tuple(
        key("rock", "number of the rock", &R::rock), key("impact", "number of its impact, from 1", &R::impact),
        quantity("time_s", "s", "time since the release", &R::time_s),
        quantity("x_m", "m", "x of its centre", &R::position_m, 0),
        quantity("y_m", "m", "y of its centre", &R::position_m, 1),
        quantity("z_m", "m", "z of its centre", &R::position_m, 2),
        quantity("vx_in_m_s", "m/s", "x of its velocity before the impact", &R::velocity_in_m_s, 0),
        quantity("vy_in_m_s", "m/s", "y of it", &R::velocity_in_m_s, 1),
        quantity("vz_in_m_s", "m/s", "z of it", &R::velocity_in_m_s, 2),
        quantity("wx_in_rad_s", "rad/s", "x of its spin before the impact", &R::spin_in_rad_s, 0),
        quantity("wy_in_rad_s", "rad/s", "y of it", &R::spin_in_rad_s, 1),
        quantity("wz_in_rad_s", "rad/s", "z of it", &R::spin_in_rad_s, 2),
        quantity("vx_out_m_s", "m/s", "x of its velocity after the impact", &R::velocity_out_m_s, 0),
        quantity("vy_out_m_s", "m/s", "y of it", &R::velocity_out_m_s, 1),
        quantity("vz_out_m_s", "m/s", "z of it", &R::velocity_out_m_s, 2),
        quantity("wx_out_rad_s", "rad/s", "x of its spin after the impact", &R::spin_out_rad_s, 0),
        quantity("wy_out_rad_s", "rad/s", "y of it", &R::spin_out_rad_s, 1),
        quantity("wz_out_rad_s", "rad/s", "z of it", &R::spin_out_rad_s, 2),
        quantity("nx", "", "x of the ground's unit normal; at an edge or a vertex, from there to the centre",
                 &R::normal, 0),
        quantity("ny", "", "y of it", &R::normal, 1), quantity("nz", "", "z of it", &R::normal, 2),
        quantity("struck_nx", "", "x of the normal that the impact law used: tilted by the ground's roughness",
                 &R::struck_normal, 0),
        quantity("struck_ny", "", "y of it", &R::struck_normal, 1),
        quantity("struck_nz", "", "z of it", &R::struck_normal, 2),
        word("ground", "material of the ground", &R::ground),
        key("facet",
            "number of the segment, triangle or cell, from 0; on an edge or a vertex one of those that meet there",
            &R::facet),
        quantity("ke_in_J", "J", "total kinetic energy before the impact", &R::ke_in_J),
        quantity("ke_out_J", "J", "total kinetic energy after it", &R::ke_out_J));
  }
};

/// A row of barriers.csv: a rock arrives at a barrier or collector.
struct HitRow {
  static constexpr const char* file_name = "barriers.csv";

  std::string barrier{};
  std::uint64_t rock = 0;
  double time_s = 0;
  std::array<double, 3> position_m{};
  double impact_height_m = 0;
  std::array<double, 3> velocity_m_s{};
  double angle_deg = 0;
  double ke_translational_J = 0, ke_rotational_J = 0, ke_total_J = 0;
  BarrierOutcome outcome = BarrierOutcome::passed;
  std::optional<std::uint64_t> ensemble{};
  double top_height_m = 0;

  static constexpr auto columns() {
    using R = HitRow;
    return std::tuple(
        word("barrier", "name of the barrier or collector", &R::barrier), key("rock", "number of the rock", &R::rock),
        quantity("time_s", "s", "time since the release", &R::time_s),
        quantity("x_m", "m", "x of its centre", &R::position_m, 0),
        quantity("y_m", "m", "y of its centre", &R::position_m, 1),
        quantity("z_m", "m", "z of its centre", &R::position_m, 2),
        quantity("impact_height_m", "m",
                 "height above the foot, along the face: of the contact point, at a collector of the centre",
                 &R::impact_height_m),
        quantity("vx_m_s", "m/s", "x of its velocity on arrival", &R::velocity_m_s, 0),
        quantity("vy_m_s", "m/s", "y of its velocity", &R::velocity_m_s, 1),
        quantity("vz_m_s", "m/s", "z of its velocity", &R::velocity_m_s, 2),
        quantity("angle_deg", "°", "angle between the velocity and the face's normal, positive towards the foot",
                 &R::angle_deg),
        quantity("ke_translational_J", "J", "translational kinetic energy", &R::ke_translational_J),
        quantity("ke_rotational_J", "J", "rotational kinetic energy", &R::ke_rotational_J),
        quantity("ke_total_J", "J", "total kinetic energy", &R::ke_total_J),
        word("outcome", "outcome of the hit", &R::outcome), key("ensemble", ensemble_meaning, &R::ensemble),
        quantity("top_height_m", "m",
                 "height of the block's top above the foot, along the face: what a fence must have to cover it",
                 &R::top_height_m));
  }
};

/// How many columns of a row the tables of a run have.
template <class Row>
[[nodiscard]] constexpr std::size_t columns_in_run(bool has_blocks) {
  return column_count<Row> - (has_blocks ? 0 : may_lack<Row>);
}

/// The rows of the tables to which rocks add while they are simulated, in the order of the files: a new table's row is
/// added here, and result_tables.cpp says which rows a rock has there.
using ResultRows = std::tuple<EndpointRow, HitRow, PathEventRow, ImpactRow>;

}  // namespace talus
