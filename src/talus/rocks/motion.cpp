#include "talus/rocks/motion.hpp"

namespace talus {

const char* name(PathState state) {
  switch (state) {
    case PathState::projectile:
      return "projectile";
    case PathState::impact:
      return "impact";
    case PathState::sliding:
      return "sliding";
    case PathState::rolling:
      return "rolling";
    case PathState::barrier:
      return "barrier";
    case PathState::ended:
      return "ended";
  }
  return "";
}

const char* name(EndReason reason) {
  switch (reason) {
    case EndReason::at_rest:
      return "at rest";
    case EndReason::left_model:
      return "left the model";
    case EndReason::no_data:
      return "no data";
    case EndReason::stopped_by_barrier:
      return "stopped by a barrier";
    case EndReason::maximum_steps:
      return "maximum steps";
    case EndReason::maximum_time:
      return "maximum time";
    case EndReason::lost:
      return "lost";
  }
  return "";
}

}  // namespace talus
