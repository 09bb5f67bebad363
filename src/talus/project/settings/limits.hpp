#pragma once
// Ranges shared by several tables, corrections of likely slips outside them, and doubts about unlikely numbers inside.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "talus/meshing/cleaning.hpp"
#include "talus/project/settings.hpp"

namespace talus::project::declared {

/// Maximum number of rocks of one seeder, and of all: far beyond any campaign, far below the overflow of 64-bit sums.
constexpr double most_rocks = 1e12;

// Limits beyond any real case, yet small enough that no product of them overflows a double: energies, times and
// distances computed from them stay finite.
constexpr double least_mass_kg = 1e-9, most_mass_kg = 1e12;
constexpr double least_volume_m3 = 1e-12, most_volume_m3 = 1e9;
constexpr double least_diameter_m = 1e-4, most_diameter_m = 1e5;
constexpr double most_speed_m_s = 1e4;
constexpr double most_rotation_deg_s = 1e6;
constexpr double least_gravity_m_s2 = 1e-6, most_gravity_m_s2 = 1e3;
constexpr double most_time_s = 1e6;
constexpr double most_height_m = 1e4;  // of barriers, kits and forests
constexpr double most_energy_kJ = 1e20;
constexpr double most_drag_kg_s = 1e12;
constexpr double most_factor = 1e6;  // of dimensionless factors and ground drag
constexpr double most_exponent = 100;
constexpr double most_store_MB = 1e6;
constexpr std::size_t most_percentiles = 20;  // each is a map per quantity, or a column

constexpr std::string_view within_places = "coordinates are in metres";
constexpr std::string_view too_fast = "no rock falls that fast";
constexpr std::string_view too_heavy = "no rock is that heavy";

constexpr Range at_least(double least, std::string_view why = {}) { return {.least = least, .too_low = why}; }
constexpr Range between(double least, double most) { return {.least = least, .most = most}; }
/// From 0, or from above 0, up to a limit beyond any real case.
constexpr Range up_to(double most, std::string_view too_low = {}, std::string_view too_high = {}) {
  return {.least = 0, .most = most, .too_low = too_low, .too_high = too_high};
}
constexpr Range above_0_up_to(double most, std::string_view too_low = {}, std::string_view too_high = {}) {
  return {.least = 0, .most = most, .least_excluded = true, .too_low = too_low, .too_high = too_high};
}
constexpr Range within(double size, std::string_view why = {}) {
  return {.least = -size, .most = size, .too_low = why, .too_high = why};
}
/// Coordinates, with the limits of terrains. (Those of lines and polygons on plan are checked in places.cpp: in the
/// message about a missing list, a range of numbers would make no sense.)
constexpr Range place = within(largest_coordinate_m, within_places);

constexpr Range restitution{
    .least = 0, .most = 1, .too_low = "a restitution cannot be negative", .too_high = "a rebound cannot gain energy"};

/// A safety factor: 1 or more, up to a limit beyond any real case.
constexpr Range factor_of_safety{.least = 1, .most = most_factor, .too_low = "a safety factor cannot be less than 1"};

/// A restitution in percent, or with its decimal point one place off.
std::optional<double> restitution_slip(double value);
/// A magnitude with a minus sign.
std::optional<double> sign_slip(double value);
/// A density in t/m3 or g/cm3.
std::optional<double> density_slip(double value);
/// A share or a confidence level in percent.
std::optional<double> percent_slip(double value);

std::optional<Doubt> radians_doubt(double value);
std::optional<Doubt> tonnes_doubt(double value);
std::optional<Doubt> mass_doubt(double value);

constexpr double largest_block_m = 20;  // a diameter; 8000 m3 by volume, 11,000 t by mass at 2700 kg/m3
constexpr const char* beyond_blocks =
    "this is larger than any rockfall block; rock masses of this size move as rock avalanches";

/// For numbers larger than any that was documented, or built.
std::function<std::optional<Doubt>(double)> beyond(double usual, std::string why, std::string hint);

}  // namespace talus::project::declared
