#pragma once
// A cache of the outlines that a rock used last: of its facet, of both in a valley, of the one beyond an edge.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "talus/terrain/contact.hpp"

namespace talus {

class KeptOutlines {
 public:
  static constexpr std::size_t count = 4;

  KeptOutlines() { facets_.fill(std::numeric_limits<std::uint32_t>::max()); }

  /// The outline of a facet, from the cache or from the surface. Valid until `count` others have been requested.
  template <class Surface>
  const Outline& of(const Surface& surface, FacetId facet) {
    // All slots are compared at once: a branch per slot could not be predicted.
    std::uint32_t places = 0;
    for (std::size_t k = 0; k < count; ++k) places |= static_cast<std::uint32_t>(facets_[k] == facet.index) << k;
    if (places != 0) return outlines_[static_cast<std::size_t>(std::countr_zero(places))];
    const std::size_t place = std::exchange(oldest_, (oldest_ + 1) % count);
    facets_[place] = facet.index;
    return outlines_[place] = surface.outline(facet);
  }

 private:
  std::array<std::uint32_t, count> facets_;
  std::array<Outline, count> outlines_;
  std::size_t oldest_ = 0;
};

}  // namespace talus
