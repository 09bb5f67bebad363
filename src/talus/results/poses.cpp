#include "talus/results/poses.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

/// As of vectors of four numbers: the cosine of half the angle between the two, or its negative.
double dot(const Orientation& a, const Orientation& b) { return a.w() * b.w() + a.xyz().dot(b.xyz()); }

/// How a block turns between two attitudes.
class Turning {
 public:
  Turning(std::span<const Attitude> attitudes, const Vec3& inertia) : attitudes_(attitudes), inertia_(inertia) {
    begin();
  }
  /// Moves on to the last attitude until this time [s]. Times do not decrease.
  void move_to(double time) {
    const std::size_t before = at_;
    while (at_ + 1 < attitudes_.size() && attitudes_[at_ + 1].time <= time) ++at_;
    if (at_ != before) begin();
  }
  [[nodiscard]] Orientation at(double time) const {
    const Attitude& from = attitudes_[at_];
    return time > from.time ? turn_.at(time - from.time).orientation : from.orientation;
  }
  [[nodiscard]] double max_spin() const { return turn_.max_spin(); }
  /// When the next attitude begins, if that is before `end` [s].
  [[nodiscard]] double until(double end) const {
    return at_ + 1 < attitudes_.size() ? std::min(attitudes_[at_ + 1].time, end) : end;
  }

 private:
  void begin() { turn_ = FreeRotation(inertia_, attitudes_[at_].orientation, attitudes_[at_].spin); }

  std::span<const Attitude> attitudes_;
  Vec3 inertia_;
  std::size_t at_ = 0;
  FreeRotation turn_{Vec3(1, 1, 1), {}, {}};
};

/// Poses that are so close to each other that a picture between them is on the path.
std::vector<Pose> close_poses(std::span<const PathPiece> pieces, std::span<const Attitude> attitudes,
                              const Vec3& inertia, const PoseTolerance& tolerance) {
  std::vector<Pose> poses;
  Turning turning(attitudes, inertia);
  const auto add = [&](const PathPiece& piece, double time) {
    const double s = std::clamp(piece.drag.parameter(time - piece.start_time), 0.0, piece.duration);
    poses.push_back({time, piece.path.at(s), turning.at(time)});
  };
  for (const PathPiece& piece : pieces) {
    const double end = piece.time(piece.duration);
    // A chord of this duration is a quarter of the tolerance from its arc, and so is an even turn, or less.
    const double chords = std::sqrt(piece.path.a.norm() / (2 * tolerance.distance));
    for (double from = piece.start_time; from < end;) {
      turning.move_to(from);
      const double to = turning.until(end);
      const double steps = (to - from) * std::max(chords, turning.max_spin() / (4 * tolerance.angle));
      const int count = 1 + static_cast<int>(std::min(steps, 1e6));
      for (int k = 0; k < count; ++k) add(piece, from + (to - from) * k / count);
      from = to;
    }
  }
  const double end = pieces.back().time(pieces.back().duration);
  turning.move_to(end);
  add(pieces.back(), end);
  return poses;
}

/// Whether a picture between two of the poses shows those between them, of which it looks at some.
bool tells(std::span<const Pose> poses, std::size_t from, std::size_t to, const PoseTolerance& tolerance) {
  constexpr std::size_t looks = 6;
  const Pose &first = poses[from], &last = poses[to];
  const std::size_t step = 1 + (to - from - 1) / looks;
  const double least_dot = std::cos(0.5 * tolerance.angle);
  for (std::size_t k = from + 1; k < to; k += step) {
    const Pose& pose = poses[k];
    const Pose seen = between(first, last, (pose.time - first.time) / (last.time - first.time));
    if ((seen.position - pose.position).squared_norm() > tolerance.distance * tolerance.distance ||
        std::abs(dot(seen.orientation, pose.orientation)) < least_dot)
      return false;
  }
  return true;
}

std::vector<Pose> thinned(std::span<const Pose> poses, const PoseTolerance& tolerance) {
  std::vector<Pose> kept{poses.front()};
  std::size_t from = 0;
  for (std::size_t to = 1; to < poses.size(); ++to) {
    if (tells(poses, from, to, tolerance)) continue;
    from = to - 1;
    kept.push_back(poses[from]);
  }
  if (poses.size() > 1) kept.push_back(poses.back());
  return kept;
}

}  // namespace

Pose between(const Pose& from, const Pose& to, double share) {
  const Orientation &a = from.orientation, &b = to.orientation;
  const double cosine = dot(a, b), half = std::acos(std::min(std::abs(cosine), 1.0));
  double of_a = 1 - share, of_b = share;
  if (half > 1e-6) {  // below it, the sines are the angles
    of_a = std::sin((1 - share) * half) / std::sin(half);
    of_b = std::sin(share * half) / std::sin(half);
  }
  if (cosine < 0) of_b = -of_b;
  const Vec3 v = of_a * a.xyz() + of_b * b.xyz();
  return {from.time + share * (to.time - from.time),
          (1 - share) * from.position + share * to.position,
          {of_a * a.w() + of_b * b.w(), v.x(), v.y(), v.z()}};
}

std::vector<Pose> poses_along(std::span<const PathPiece> pieces, std::span<const Attitude> attitudes,
                              const Vec3& inertia, PoseTolerance tolerance, std::size_t max_poses) {
  const std::vector<Pose> close = close_poses(pieces, attitudes, inertia, tolerance);
  std::vector<Pose> poses = thinned(close, tolerance);
  while (poses.size() > max_poses) {
    tolerance = {2 * tolerance.distance, 2 * tolerance.angle};
    poses = thinned(close, tolerance);
  }
  return poses;
}

}  // namespace talus
