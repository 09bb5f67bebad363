#pragma once
// How far a convex edge of the ground, a ridge, is from a body, and where they touch.
//
// A point x is outside of the body by phi(x), the largest of n . x - d over its faces: along a ridge a convex function
// of straight pieces. Its minimum is the gap: positive if and only if the ridge misses the body, and never more than
// their distance. Where it lies inside the ridge, two faces meet there, on whose edge or corner the ridge lies; where
// at an end, a vertex of the ground lies on a face. The normal is that of the one face, or the mix of both normals that
// is across the ridge: up to its length the cross product of both edges.
//
// Checked by test/rocks/ridge_test.cpp.

#include <cstdint>
#include <optional>
#include <span>

#include "talus/core/id.hpp"
#include "talus/rocks/shape.hpp"

namespace talus {

/// In a section it is a vertex: both ends are the same.
struct Ridge {
  Vec3 from, to;
  FacetId facet;           // one of those that meet there
  std::uint32_t side = 0;  // of that facet
};

/// Where a ridge is nearest to a body or deepest in it. `s`: from 0 to 1 along the ridge.
struct RidgeGap {
  double gap;  // [m]
  double s;
  std::uint32_t face, other;  // of the body; the same if it is one
  double share;               // of the normal of `face` in the mix
};

/// Of a ridge, from 0 to 1.
struct RidgePart {
  double from = 0, to = 1;
};

/// nullopt if the gap is more than `bound` [m]. `faces`: the numbers of those that count, at least one.
[[nodiscard]] std::optional<RidgeGap> ridge_gap(const Posture& body, std::span<const std::uint32_t> faces,
                                                const Ridge& ridge, double bound, RidgePart part = {});

/// Of a touch: unit, from the ridge to the body.
[[nodiscard]] Vec3 normal_at(const Posture& body, const RidgeGap& gap);

/// The part of a ridge that is outside of the body by no more than `bound` [m], which must be no less than its gap.
[[nodiscard]] RidgePart part_within(const Posture& body, const Ridge& ridge, double bound);

/// How far straight up from the bottom of a body a point in it is [m].
[[nodiscard]] double height_in(const Posture& body, const Vec3& place);

}  // namespace talus
