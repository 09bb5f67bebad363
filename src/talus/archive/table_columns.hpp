#pragma once
// The tables of a run: their rows and columns, for what writes them and what reads them.

#include <array>
#include <cstdint>
#include <string>
#include <tuple>

#include "talus/archive/typed_columns.hpp"
#include "talus/barriers/barrier.hpp"
#include "talus/rocks/motion.hpp"

namespace talus::io {

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

/// A row of endpoints.csv: how a rock ended. Positions are the user's.
struct EndpointRow {
  static constexpr const char* file_name = "endpoints.csv";

  std::uint64_t rock = 0;
  std::string seeder{};
  std::array<double, 3> position_m{};
  double runout_xy_m = 0, runout_z_m = 0, runout_total_m = 0, time_s = 0;
  std::uint64_t events = 0;
  EndReason end_reason = EndReason::at_rest;
  double mass_kg = 0, radius_m = 0, max_ke_J = 0, max_bounce_m = 0;

  static constexpr auto columns() {
    using R = EndpointRow;
    return std::tuple(
        key("rock", "number of the rock, from 0, seeder after seeder", &R::rock),
        word("seeder", "name of its seeder", &R::seeder),
        quantity("x_m", "m", "where its centre ended", &R::position_m, 0),
        quantity("y_m", "m", "likewise", &R::position_m, 1), quantity("z_m", "m", "likewise", &R::position_m, 2),
        quantity("runout_xy_m", "m", "from start to end on plan", &R::runout_xy_m),
        quantity("runout_z_m", "m", "start's z less end's z: positive downwards", &R::runout_z_m),
        quantity("runout_total_m", "m", "from start to end, the straight line in space", &R::runout_total_m),
        quantity("time_s", "s", "from release to end", &R::time_s),
        quantity("events", "", "arrivals: impacts and barriers", &R::events),
        word("end_reason", "why the path ended", &R::end_reason), quantity("mass_kg", "kg", "mass", &R::mass_kg),
        quantity("radius_m", "m", "radius of the equivalent sphere", &R::radius_m),
        quantity("max_ke_J", "J", "greatest kinetic energy, translational and rotational", &R::max_ke_J),
        quantity("max_bounce_m", "m",
                 "greatest bounce height: of the centre above the ground below it, in flight, and of a sphere on the "
                 "ground, too",
                 &R::max_bounce_m));
  }
};

/// A row of paths.csv: a rock in one moment of its path.
struct PathEventRow {
  static constexpr const char* file_name = "paths.csv";

  std::uint64_t rock = 0, event = 0;
  PathState state = PathState::projectile;
  double time_s = 0;
  std::array<double, 3> position_m{}, velocity_m_s{}, spin_rad_s{};
  double ke_translational_J = 0, ke_rotational_J = 0, pe_J = 0;
  [[nodiscard]] double total_J() const { return ke_translational_J + ke_rotational_J + pe_J; }

  static constexpr auto columns() {
    using R = PathEventRow;
    return std::tuple(
        key("rock", "number of the rock", &R::rock), key("event", "number of the row, from 0", &R::event),
        word("state", "what it does from now on; `impact`, `barrier`: it arrives", &R::state),
        quantity("time_s", "s", "since release", &R::time_s), quantity("x_m", "m", "of the centre", &R::position_m, 0),
        quantity("y_m", "m", "likewise", &R::position_m, 1), quantity("z_m", "m", "likewise", &R::position_m, 2),
        quantity("vx_m_s", "m/s", "velocity", &R::velocity_m_s, 0),
        quantity("vy_m_s", "m/s", "likewise", &R::velocity_m_s, 1),
        quantity("vz_m_s", "m/s", "likewise", &R::velocity_m_s, 2),
        quantity("wx_rad_s", "rad/s", "spin about the axes of the coordinates", &R::spin_rad_s, 0),
        quantity("wy_rad_s", "rad/s", "likewise: rolling towards +x is positive", &R::spin_rad_s, 1),
        quantity("wz_rad_s", "rad/s", "likewise", &R::spin_rad_s, 2),
        quantity("ke_translational_J", "J", "kinetic energy of the motion", &R::ke_translational_J),
        quantity("ke_rotational_J", "J", "kinetic energy of the spin", &R::ke_rotational_J),
        quantity("pe_J", "J", "potential energy above the datum", &R::pe_J));
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

  static constexpr auto columns() {
    using R = HitRow;
    return std::tuple(
        word("barrier", "its name", &R::barrier), key("rock", "number of the rock", &R::rock),
        quantity("time_s", "s", "since release", &R::time_s), quantity("x_m", "m", "of the centre", &R::position_m, 0),
        quantity("y_m", "m", "likewise", &R::position_m, 1), quantity("z_m", "m", "likewise", &R::position_m, 2),
        quantity("impact_height_m", "m",
                 "above the foot, along the face: of the contact point; at a collector, of the centre",
                 &R::impact_height_m),
        quantity("vx_m_s", "m/s", "velocity as it arrives", &R::velocity_m_s, 0),
        quantity("vy_m_s", "m/s", "likewise", &R::velocity_m_s, 1),
        quantity("vz_m_s", "m/s", "likewise", &R::velocity_m_s, 2),
        quantity("angle_deg", "°", "between velocity and the face's normal, positive towards the foot", &R::angle_deg),
        quantity("ke_translational_J", "J", "kinetic energy of the motion", &R::ke_translational_J),
        quantity("ke_rotational_J", "J", "kinetic energy of the spin", &R::ke_rotational_J),
        quantity("ke_total_J", "J", "both", &R::ke_total_J), word("outcome", "what came of it", &R::outcome));
  }
};

inline constexpr const auto& endpoint_columns = column_names<EndpointRow>;
inline constexpr const auto& path_columns = column_names<PathEventRow>;
inline constexpr const auto& barrier_columns = column_names<HitRow>;

}  // namespace talus::io
