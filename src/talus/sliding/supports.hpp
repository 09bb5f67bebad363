#pragma once
// Where a rock that touches several facets can move: down one of them, along a valley between two, or nowhere.

#include <array>

#include "talus/sliding/leg.hpp"

namespace talus {

/// Unit normals of the facets that a rock touches; nearly equal ones are kept once.
class Supports {
 public:
  void add(const Vec3& n);
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const Vec3& operator[](int i) const { return normals_[static_cast<std::size_t>(i)]; }

 private:
  std::array<Vec3, 8> normals_;
  int count_ = 0;
};

/// The pull and the sum of normal forces on frictionless supports: the projection of gravity onto the cone of
/// directions that enter none of them, found by trying every one, two and three of them as the ones that carry.
[[nodiscard]] Footing footing_on(const Vec3& gravity, const Supports& supports);

/// Two supports between which a rock is caught: the line along which it can move, and its footing there.
struct Valley {
  Vec3 direction;  // unit, along both
  Footing footing;
  double first_share;  // the first support's share of the normal forces
};

/// Whether a rock that leaves a contact with the second of two neighbouring supports at `velocity` stays in the valley
/// between them: gravity drives it from each onto the other, and it moves away from the first more slowly than `cutoff`
/// [m/s].
[[nodiscard]] bool is_caught_between(const Vec3& gravity, const Vec3& first, const Vec3& second, const Vec3& velocity,
                                     double cutoff);

/// The valley between two supports that hold a rock.
[[nodiscard]] Valley valley_between(const Vec3& gravity, const Vec3& first, const Vec3& second);

}  // namespace talus
