#pragma once
// A rock and its motion at release.

#include "talus/core/orientation.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/rocks/rock.hpp"
#include "talus/rocks/shape.hpp"

namespace talus {

struct Release {
  Motion motion;
  Rock rock;
  const RockShape* shape = nullptr;  // null: a sphere, or a point
  Orientation orientation{};     // of a shape
  bool has_room = true;          // if false, the rock does not fit where it is released, and rests there
};

}  // namespace talus
