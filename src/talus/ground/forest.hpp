#pragma once
// The drag of forests on rocks, by density.
//
// RAMMS::ROCKFALL and RocFall offer an open, a medium and a dense forest, each with a drag b for the force -b v
// (rocks/drag.hpp); RocFall's help cites Bartelt et al. 2016, the manual of RAMMS::ROCKFALL. The values below are
// those commonly quoted from it, for stands of 20, 35 and 50 m2/ha. They could not be checked against the manual
// itself: if a result depends on them, set the drag.

namespace talus {

enum class Forest { none, open, medium, dense };

/// b [kg/s].
[[nodiscard]] inline double forest_drag(Forest density) {
  switch (density) {
    case Forest::none:
      return 0;
    case Forest::open:
      return 250;
    case Forest::medium:
      return 500;
    case Forest::dense:
      return 750;
  }
  return 0;
}

}  // namespace talus
