#pragma once
// A rock and its motion at release.

#include "talus/rocks/motion.hpp"
#include "talus/rocks/rock.hpp"

namespace talus {

struct Release {
  Motion motion;
  Rock rock;
  bool has_room = true;  // if false, the rock does not fit where it is released, and rests there
};

}  // namespace talus
