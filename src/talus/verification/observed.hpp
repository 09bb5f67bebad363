#pragma once
// What a verification looks at: a rock's path as a replay shows it, and one value a rock or a hit.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/rocks/rock.hpp"

namespace talus::verification {

enum class PathQuantity {
  time,          // [s]
  time_to_next,  // to the next row [s]
  x,
  y,
  z,  // [m]
  vx,
  vy,
  vz,  // [m/s]
  wx,
  wy,
  wz,    // [rad/s]
  spin,  // magnitude of the angular velocity [rad/s]; signs in section differ between the programs
  kinetic_J,
  potential_J,
  total_J,
  kinetic_kJ,
  potential_kJ,
  total_kJ
};
[[nodiscard]] std::string_view name(PathQuantity quantity);
[[nodiscard]] std::optional<PathQuantity> path_quantity_of(std::string_view name);
[[nodiscard]] std::vector<std::string_view> path_quantity_names();

/// Quantities of one kind share a scale: positions, velocities, spins, times, energies.
enum class Kind { time, position, velocity, spin, energy };
[[nodiscard]] Kind kind_of(PathQuantity quantity);

enum class SampleQuantity {
  runout_xy_m,                  // one a rock: way from start to end on plan
  end_x_m,                      // one a rock
  barrier_ke_translational_kJ,  // one a hit
  barrier_height_m              // one a hit: along the barrier
};
inline constexpr int sample_quantity_count = 4;
[[nodiscard]] std::string_view name(SampleQuantity quantity);
[[nodiscard]] std::optional<SampleQuantity> sample_quantity_of(std::string_view name);
[[nodiscard]] std::vector<std::string_view> sample_quantity_names();

/// A row of a path in the user's coordinates.
struct Event {
  Motion motion;
  double kinetic = 0, potential = 0;  // [J]
};

/// `next` is the row after it, where there is one.
[[nodiscard]] std::optional<double> value(PathQuantity quantity, const Event& event, const Event* next);

/// The path of one rock as `talus replay` shows it: all rows, and where it turns back between them.
[[nodiscard]] std::vector<Event> path_of(const Model& model, std::uint64_t rock);

/// What a campaign leaves to be compared.
struct Observed {
  std::uint64_t rocks = 0;
  std::array<std::vector<double>, sample_quantity_count> samples;  // in the order of rocks
  std::array<std::uint64_t, end_reason_count> ends{};
  /// The most that the total energy rose between two rows of a path, as a part of the greatest energy (kinetic, and
  /// potential above the lowest row) of that path. Only where energies were asked for.
  double greatest_energy_rise = 0;

  [[nodiscard]] const std::vector<double>& sample(SampleQuantity quantity) const {
    return samples[static_cast<std::size_t>(quantity)];
  }
};

enum class Energies { skip, watch };
/// Runs all rocks of the model on all cores.
[[nodiscard]] Observed observe(const Model& model, Energies energies);

}  // namespace talus::verification
