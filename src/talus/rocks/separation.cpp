#include "talus/rocks/separation.hpp"

#include <limits>

namespace talus {

namespace {

/// A point of the body, from one of the polygon.
struct Difference {
  Vec3 way;
  Vec3 on_polygon;  // from the body's centre
};

/// Up to four differences, and the point of their hull that is nearest to 0.
class Simplex {
 public:
  explicit Simplex(const Difference& first) : points_{first}, size_(1), nearest_(first.way), shares_{1} {}

  [[nodiscard]] const Vec3& nearest() const { return nearest_; }
  [[nodiscard]] Vec3 on_polygon() const {
    Vec3 sum;
    for (std::size_t i = 0; i < size_; ++i) sum += shares_[i] * points_[i].on_polygon;
    return sum;
  }
  /// Adds a point, and keeps those that the nearest point then lies between. False if that is no nearer to 0, or 0.
  [[nodiscard]] bool add(const Difference& added) {
    Best best;
    for (unsigned set = 0; set < (1U << size_); ++set) look_at(set, added, best);
    if (best.is_inside || !(best.squared < nearest_.squared_norm())) {
      if (best.is_inside) nearest_ = {};
      return false;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if ((best.set >> i & 1U) == 0) continue;
      shares_[kept] = best.shares[kept];
      points_[kept++] = points_[i];
    }
    shares_[kept] = 1;
    for (std::size_t i = 0; i < kept; ++i) shares_[kept] -= shares_[i];
    points_[kept] = added;
    size_ = kept + 1;
    nearest_ = best.nearest;
    return true;
  }

 private:
  struct Best {
    double squared = std::numeric_limits<double>::infinity();
    unsigned set = 0;
    Vec3 nearest, shares;
    bool is_inside = false;
  };
  /// The point nearest to 0 of the plane, line or point through the added point and a set of others, if it is between
  /// them.
  void look_at(unsigned set, const Difference& added, Best& best) const {
    std::array<Vec3, 3> sides;
    std::size_t count = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if ((set >> i & 1U) == 0) continue;
      if (count == sides.size()) return;
      sides[count++] = points_[i].way - added.way;
    }
    const Vec3& from = added.way;
    Vec3 shares;
    if (count == 1) shares[0] = -from.dot(sides[0]) / sides[0].squared_norm();
    if (count == 2) {
      const double aa = sides[0].squared_norm(), ab = sides[0].dot(sides[1]), bb = sides[1].squared_norm();
      const double a = -from.dot(sides[0]), b = -from.dot(sides[1]), determinant = aa * bb - ab * ab;
      shares[0] = (a * bb - b * ab) / determinant;
      shares[1] = (b * aa - a * ab) / determinant;
    }
    if (count == 3) shares = Mat3::of_columns(sides[0], sides[1], sides[2]).solve(-from);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!(shares[i] >= 0)) return;
      sum += shares[i];
    }
    if (!(sum <= 1)) return;
    if (count == 3) {
      best.is_inside = true;
      return;
    }
    Vec3 nearest = from;
    for (std::size_t i = 0; i < count; ++i) nearest += shares[i] * sides[i];
    const double squared = nearest.squared_norm();
    if (squared < best.squared) best = {squared, set, nearest, shares, best.is_inside};
  }

  std::array<Difference, 4> points_;
  std::size_t size_;
  Vec3 nearest_;
  std::array<double, 4> shares_;
};

}  // namespace

std::optional<Separation> separation(const Posture& body, std::span<const Vec3> polygon) {
  constexpr int max_rounds = 64;
  constexpr double accuracy = 1e-6, touching = 1e-9;  // a share of the distance; [m]
  const Mat3 to_shape = body.turned.transposed();
  // The difference that is farthest against a direction.
  const auto farthest_against = [&](const Vec3& direction) {
    const Vec3 in_shape = to_shape * direction;
    std::size_t corner = 0, other = 0;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t i = 0; i < body.corners.size(); ++i) {
      const double along = in_shape.dot(body.corners[i]);
      if (along < least) corner = i;
      least = std::min(least, along);
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const double along = direction.dot(polygon[i] - body.centre);
      if (along > most) other = i;
      most = std::max(most, along);
    }
    const Vec3 on_polygon = polygon[other] - body.centre;
    return Difference{body.arm(corner) - on_polygon, on_polygon};
  };
  Simplex simplex(farthest_against(body.centre - polygon[0]));
  for (int round = 0; round < max_rounds; ++round) {
    const Vec3& nearest = simplex.nearest();
    const double squared = nearest.squared_norm();
    if (squared < touching * touching) return std::nullopt;
    const Difference next = farthest_against(nearest);
    if (squared - nearest.dot(next.way) <= accuracy * squared || !simplex.add(next)) break;
  }
  const double distance = simplex.nearest().norm();
  if (distance < touching) return std::nullopt;
  return Separation{distance, simplex.nearest() / distance, body.centre + simplex.on_polygon()};
}

}  // namespace talus
