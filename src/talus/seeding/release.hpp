#pragma once
// How a rock starts.

#include "talus/motion/motion.hpp"
#include "talus/rocks/rock.hpp"

namespace talus {

struct Release {
  Motion motion;
  Rock rock;
};

}  // namespace talus
