#pragma once
// The quantities of the rocks' motion that maps and envelopes show, and how a cell gets their values. Their names,
// units and classes are in maps/map_subjects.hpp.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "talus/trajectory/piece_maxima.hpp"

namespace talus {

/// A rock counts in a cell once, with the maximum of its stay there; if it comes again, with the maximum of all its
/// stays. Each quantity has its own maximum.
enum class MapQuantity : std::uint32_t {
  energy_total,          // translational and rotational [J]
  energy_translational,  // [J]
  velocity,              // [m/s]
  bounce_height          // rocks/heights.hpp [m]
};
inline constexpr std::size_t map_quantity_count = 4;

/// The maximum of a quantity over a stay in a cell, from the stay's maxima of motion and of bounce height [m]. 0 or
/// more.
[[nodiscard]] inline double value_of(MapQuantity quantity, const MaxMotion& motion, double height) {
  switch (quantity) {
    case MapQuantity::energy_total:
      return motion.energy_total;
    case MapQuantity::energy_translational:
      return motion.energy_translational;
    case MapQuantity::velocity:
      return std::sqrt(motion.squared_velocity);
    case MapQuantity::bounce_height:
      return height;
  }
  return 0;
}

}  // namespace talus
