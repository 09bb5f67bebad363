#pragma once
// The columns of the tables of a run, in their order: what writes them and what reads them.

#include <array>
#include <cstddef>
#include <string_view>

namespace talus::io {

inline constexpr std::array<std::string_view, 15> endpoint_columns{
    "rock",   "seeder", "x_m",        "y_m",     "z_m",      "runout_xy_m", "runout_z_m",  "runout_total_m",
    "time_s", "events", "end_reason", "mass_kg", "radius_m", "max_ke_J",    "max_bounce_m"};
inline constexpr std::array<std::string_view, 16> path_columns{"rock",
                                                               "event",
                                                               "state",
                                                               "time_s",
                                                               "x_m",
                                                               "y_m",
                                                               "z_m",
                                                               "vx_m_s",
                                                               "vy_m_s",
                                                               "vz_m_s",
                                                               "wx_rad_s",
                                                               "wy_rad_s",
                                                               "wz_rad_s",
                                                               "ke_translational_J",
                                                               "ke_rotational_J",
                                                               "pe_J"};
inline constexpr std::array<std::string_view, 15> barrier_columns{
    "barrier",         "rock",       "time_s", "x_m",    "y_m",       "z_m",
    "impact_height_m", "vx_m_s",     "vy_m_s", "vz_m_s", "angle_deg", "ke_translational_J",
    "ke_rotational_J", "ke_total_J", "outcome"};

/// A column's place by its name, while compiling: readers say "x_m" and never 4.
template <std::size_t n>
constexpr std::size_t place_of(const std::array<std::string_view, n>& columns, std::string_view name) {
  for (std::size_t k = 0; k < n; ++k) {
    if (columns[k] == name) return k;
  }
  throw "no such column";  // refused while compiling
}

}  // namespace talus::io
