#pragma once
// How strongly forests brake rocks, by their density.
//
// RAMMS::ROCKFALL and RocFall offer an open, a medium and a dense forest, each with its drag b of the force -b v
// (flight/drag.hpp); RocFall's help names Bartelt et al. 2016, the manual of RAMMS::ROCKFALL, for them. The numbers
// below are those that are commonly quoted from it, for stands of 20, 35 and 50 m2/ha. They could not be checked
// against the manual itself: where a result hangs on them, give the drag.

namespace talus {

enum class ForestDensity { open, medium, dense };

/// b [kg/s].
[[nodiscard]] inline double forest_drag(ForestDensity density) {
  switch (density) {
    case ForestDensity::open:
      return 250;
    case ForestDensity::medium:
      return 500;
    case ForestDensity::dense:
      return 750;
  }
  return 0;
}

}  // namespace talus
