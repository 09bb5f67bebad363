#pragma once
// The data that a verification compares: the path of a rock as in a replay, and one value per rock or hit.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
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
  total_kJ,
  // Of a block, at given times.
  spin_a,
  spin_b,
  spin_c,     // its own spin about its principal axes, from the longest to the shortest [rad/s]
  turned_deg  // the angle from its orientation at release, 0 to 180 degrees
};
[[nodiscard]] std::string_view name(PathQuantity quantity);
[[nodiscard]] std::optional<PathQuantity> path_quantity_of(std::string_view name);
[[nodiscard]] std::vector<std::string_view> path_quantity_names();

/// Quantities of one kind share a scale: positions, velocities, spins, times, energies, angles.
enum class Kind { time, position, velocity, spin, energy, angle };
inline constexpr int kind_count = 6;
[[nodiscard]] Kind kind_of(PathQuantity quantity);

enum class SampleQuantity {
  runout_xy_m,                  // one per rock: distance on plan from start to end
  end_x_m,                      // one per rock
  barrier_ke_translational_kJ,  // one per hit
  barrier_height_m              // one per hit: height along the barrier
};
inline constexpr int sample_quantity_count = 4;
[[nodiscard]] std::string_view name(SampleQuantity quantity);
[[nodiscard]] std::optional<SampleQuantity> sample_quantity_of(std::string_view name);
[[nodiscard]] std::vector<std::string_view> sample_quantity_names();

/// A row of a path in the user's coordinates.
struct Event {
  Motion motion;
  double kinetic = 0, potential = 0;  // [J]
  /// Of a block, at a given time.
  struct Turning {
    Vec3 spin;         // its own, about its principal axes [rad/s]
    double angle = 0;  // from its orientation at release [rad]
  };
  std::optional<Turning> turning;
};

/// `next` is the following row; null if there is none.
[[nodiscard]] std::optional<double> value(PathQuantity quantity, const Event& event, const Event* next);

/// The path of one rock as in `talus replay`: all rows, and the points between them where it turns back.
[[nodiscard]] std::vector<Event> path_of(const Model& model, std::uint64_t rock);

/// Its motion at times since its release, up to its end [s]. A block's spin there is its own, not that of its sphere.
[[nodiscard]] std::vector<Event> path_at(const Model& model, std::uint64_t rock, std::span<const double> times);

/// The results of a campaign that are compared.
struct Observed {
  std::uint64_t rocks = 0;
  std::array<std::vector<double>, sample_quantity_count> samples;  // in the order of the rocks
  std::array<std::uint64_t, end_reason_count> ends{};
  /// Maximum rise of the total energy between two rows of a path, relative to the maximum energy (kinetic, and
  /// potential above the lowest row) of that path. Only with Energies::watch.
  double max_energy_rise = 0;

  [[nodiscard]] const std::vector<double>& sample(SampleQuantity quantity) const {
    return samples[static_cast<std::size_t>(quantity)];
  }
};

enum class Energies { skip, watch };
/// Runs all rocks of the model on all cores.
[[nodiscard]] Observed observe(const Model& model, Energies energies);

}  // namespace talus::verification
