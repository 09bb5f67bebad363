#pragma once
// Random numbers for test cases: the same on every platform, unlike the standard library's distributions.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "support/maps_of_space.hpp"
#include "support/print_vec.hpp"

namespace talus::testing_tools {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Log-uniform, over several orders of magnitude.
  double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool chance(double probability) { return unit() < probability; }

  Vec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  Vec3 direction() {
    const double z = between(-1, 1), angle = between(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  /// A rotation by a random angle about a random axis.
  Map3 turn() {
    const double angle = between(0, 2 * std::numbers::pi);
    return turn_about(direction(), angle);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace talus::testing_tools
