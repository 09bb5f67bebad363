#include "talus/lines/stored_paths.hpp"

#include <utility>

namespace talus {

void StoredPaths::read(std::size_t place, RockPath& into) const {
  thread_local StoredTrajectory stored;
  std::swap(stored.pieces, into.pieces);  // its memory is used again
  store_.read(place, stored);
  into.record = stored.record;
  std::swap(stored.pieces, into.pieces);
}

}  // namespace talus
