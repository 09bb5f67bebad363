#pragma once
// How a rock starts.

#include "talus/rocks/motion.hpp"
#include "talus/rocks/rock.hpp"

namespace talus {

struct Release {
  Motion motion;
  Rock rock;
  bool has_room = true;  // otherwise it is caught where it is, and stays there
};

}  // namespace talus
