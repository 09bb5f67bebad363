#pragma once
// Bumps along the way: where a rock that slides or rolls over rough ground strikes a face of it. The way from bump to
// bump is exponentially distributed, its mean the spacing of the ground (RoughGround::bump_spacing). It is counted in
// spacings, from a stream of random numbers of its own, so that it depends on the rock, the materials and the way along
// the ground, and not on facets, legs or flights between.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "talus/sampling/draws.hpp"

namespace talus {

class Bumps {
 public:
  /// The way to the next bump on ground of this spacing [m].
  [[nodiscard]] double way(const Draws& draws, double spacing) {
    if (left_ < 0) left_ = -std::log(draws.one(Stream::bump, number_));
    return left_ * spacing;
  }
  /// The rock has moved along ground of this spacing, not beyond the next bump [m].
  void cover(double way, double spacing) {
    if (left_ >= 0) left_ = std::max(0.0, left_ - way / spacing);
  }
  /// The rock has met the bump.
  void pass() {
    left_ = not_drawn;
    ++number_;
  }

 private:
  static constexpr double not_drawn = -1;
  double left_ = not_drawn;   // to the next bump, in spacings; drawn when it is first asked for
  std::uint32_t number_ = 0;  // of bumps met
};

}  // namespace talus
