#include "talus/rocks/ridge.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace talus {

namespace {

/// A ridge in the frame and the scale of a body's shape.
struct RidgeInShape {
  Vec3 from, along;
  double scale;  // of the body [m]

  RidgeInShape(const Posture& body, const Ridge& ridge) {
    const double squared = body.turned.rows[0].squared_norm();
    const Mat3 to_shape = body.turned.transposed();
    from = to_shape * (ridge.from - body.centre) / squared;
    along = to_shape * (ridge.to - ridge.from) / squared;
    scale = std::sqrt(squared);
  }
};

/// A straight piece of phi: its value at s = 0, and its slope.
struct Piece {
  double start, slope;
  std::uint32_t face;
  [[nodiscard]] double at(double s) const { return start + s * slope; }
};

}  // namespace

std::optional<RidgeGap> ridge_gap(const Posture& body, std::span<const std::uint32_t> faces, const Ridge& ridge,
                                  double bound, RidgePart part) {
  RidgeInShape in(body, ridge);
  in.from += part.from * in.along;
  in.along *= part.to - part.from;
  const double limit = bound / in.scale;
  const auto piece_of = [&](std::uint32_t f) {
    const HullFace& face = body.hull->faces[f];
    return Piece{face.normal.dot(in.from) - face.offset, face.normal.dot(in.along), f};
  };
  // The highest pieces at both ends. Most ridges are beyond the plane of one face with both.
  constexpr std::size_t max_kept = 64;
  std::array<Piece, max_kept> kept;
  Piece left = piece_of(faces[0]), right = left;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Piece piece = piece_of(faces[i]);
    const double end = piece.at(1);
    if (piece.start > limit && end > limit) return std::nullopt;
    if (i < max_kept) kept[i] = piece;
    if (piece.start > left.start) left = piece;
    if (end > right.at(1)) right = piece;
  }
  const auto found = [&](double gap, double s, std::uint32_t face, std::uint32_t other,
                         double share) -> std::optional<RidgeGap> {
    if (gap > limit) return std::nullopt;
    return RidgeGap{gap * in.scale, part.from + s * (part.to - part.from), face, other, share};
  };
  if (left.slope >= 0) return found(left.start, 0, left.face, left.face, 1);
  if (right.slope <= 0) return found(right.at(1), 1, right.face, right.face, 1);
  // Between a falling and a rising piece. Each round finds a piece that is higher where they cross, or none.
  for (std::size_t round = 0; round < faces.size(); ++round) {
    const double s = std::clamp((left.start - right.start) / (right.slope - left.slope), 0.0, 1.0);
    const double crossing = left.at(s);
    if (crossing > limit) return std::nullopt;
    Piece highest = left;
    double most = crossing + 1e-12;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Piece piece = i < max_kept ? kept[i] : piece_of(faces[i]);
      if (piece.at(s) > most) highest = piece, most = piece.at(s);
    }
    if (most == crossing + 1e-12 || highest.slope == 0) {
      if (highest.face != left.face) return found(highest.start, s, highest.face, highest.face, 1);
      return found(crossing, s, left.face, right.face, right.slope / (right.slope - left.slope));
    }
    (highest.slope < 0 ? left : right) = highest;
  }
  const double s = std::clamp((left.start - right.start) / (right.slope - left.slope), 0.0, 1.0);
  return found(left.at(s), s, left.face, right.face, right.slope / (right.slope - left.slope));
}

Vec3 normal_at(const Posture& body, const RidgeGap& gap) {
  const Vec3 out = gap.share * body.hull->faces[gap.face].normal + (1 - gap.share) * body.hull->faces[gap.other].normal;
  return -(body.turned * out).normalized();
}

RidgePart part_within(const Posture& body, const Ridge& ridge, double bound) {
  const RidgeInShape in(body, ridge);
  RidgePart part{0, 1};
  for (const HullFace& face : body.hull->faces) {
    const double room = bound / in.scale + face.offset - face.normal.dot(in.from), slope = face.normal.dot(in.along);
    if (slope > 0) part.to = std::min(part.to, room / slope);
    if (slope < 0) part.from = std::max(part.from, room / slope);
  }
  return part;
}

double height_in(const Posture& body, const Vec3& place) {
  const double squared = body.turned.rows[0].squared_norm();
  const Vec3 in_shape = body.turned.transposed() * (place - body.centre) / squared;
  const Vec3 down = -body.turned.rows[2] / squared;  // for each metre
  double height = std::numeric_limits<double>::infinity();
  for (const HullFace& face : body.hull->faces) {
    const double rate = face.normal.dot(down);
    if (rate > 0) height = std::min(height, (face.offset - face.normal.dot(in_shape)) / rate);
  }
  return std::max(height, 0.0);
}

}  // namespace talus
