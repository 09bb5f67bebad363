#include "talus/lines/stored_paths.hpp"

#include <utility>

namespace talus {

void StoredPaths::read(std::size_t place, RockPath& into) const {
  thread_local StoredTrajectory stored;
  std::swap(stored.pieces, into.pieces);  // their memory is used again
  std::swap(stored.rows, into.rows);
  store_.read(place, stored);
  into.record = stored.record;
  std::swap(stored.pieces, into.pieces);
  std::swap(stored.rows, into.rows);
}

}  // namespace talus
