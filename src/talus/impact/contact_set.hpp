#pragma once
// Where a rock touches the ground at one moment: a point in one place, a rock with a shape in up to four.

#include <array>
#include <cstddef>
#include <cstdint>

#include "talus/core/check.hpp"
#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

namespace talus {

struct ContactPoint {
  Vec3 arm;                  // from the rock's centre of mass to the point [m]
  Vec3 normal;               // unit, out of the ground, roughness included
  FacetId facet{};           // of the ground
  std::uint32_t corner = 0;  // of a rock with a shape; or on a ridge of the ground, as TouchPart says
  double gap = 0;            // of the point above the ground; negative in the ground [m]
};

/// In the order in which an impact law takes them. At most four: more do not change how a rigid body moves, only how
/// its contacts share the impulses.
class ContactSet {
 public:
  static constexpr std::size_t most = 4;

  ContactSet() = default;
  ContactSet(const ContactPoint& only) : points_{only}, size_(1) {}  // NOLINT(google-explicit-constructor)

  void add(const ContactPoint& point) {
    TALUS_PROMISE(size_ < most, "more contacts than a set holds");
    points_[size_++] = point;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const ContactPoint& operator[](std::size_t i) const { return points_[i]; }
  [[nodiscard]] const ContactPoint* begin() const { return points_.data(); }
  [[nodiscard]] const ContactPoint* end() const { return points_.data() + size_; }

 private:
  std::array<ContactPoint, most> points_;
  std::size_t size_ = 0;
};

}  // namespace talus
