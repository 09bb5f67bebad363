#include "talus/archive/path_arcs.hpp"

#include <algorithm>
#include <cmath>

#include "talus/core/vec.hpp"

namespace talus {

namespace {

PathPoint point_of(const PathEventRow& row) {
  return {.time_s = row.time_s,
          .position_m = row.position_m,
          .velocity_m_s = row.velocity_m_s,
          .ke_total_J = row.ke_translational_J + row.ke_rotational_J,
          .state = row.state};
}

/// The flight between two rows.
class Arc {
 public:
  Arc(const PathEventRow& from, const PathEventRow& to)
      : from_(from), duration_(to.time_s - from.time_s), p_(vector(from.position_m)), v_(vector(from.velocity_m_s)) {
    if (duration_ <= 0) return;
    const Vec3 way = vector(to.position_m) - p_, v_end = vector(to.velocity_m_s);
    // p + v t + a t^2/2 + j t^3/6
    a_ = (6 * way / duration_ - 4 * v_ - 2 * v_end) / duration_;
    j_ = (6 * (v_ + v_end) - 12 * way / duration_) / (duration_ * duration_);
    const PathEventRow& faster = v_end.squared_norm() > v_.squared_norm() ? to : from;
    const double squared = vector(faster.velocity_m_s).squared_norm();
    if (squared > 0) mass_ = 2 * faster.ke_translational_J / squared;
  }

  /// The number of pieces for which the lines are within a tolerance.
  [[nodiscard]] int pieces(double tolerance) const {
    if (duration_ <= 0) return 1;
    const double greatest = std::max(a_.norm(), (a_ + duration_ * j_).norm());
    const double count = std::ceil(duration_ * std::sqrt(greatest / (8 * tolerance)));
    return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(most_pieces_of_a_flight)));
  }

  [[nodiscard]] PathPoint at(double t) const {
    const Vec3 velocity = v_ + t * (a_ + t / 2 * j_);
    return {.time_s = from_.time_s + t,
            .position_m = coordinates(p_ + t * (v_ + t / 2 * (a_ + t / 3 * j_))),
            .velocity_m_s = coordinates(velocity),
            .ke_total_J = 0.5 * mass_ * velocity.squared_norm() + from_.ke_rotational_J,
            .state = from_.state};
  }
  [[nodiscard]] double duration() const { return duration_; }

 private:
  const PathEventRow& from_;
  double duration_, mass_ = 0;
  Vec3 p_, v_, a_, j_;
};

}  // namespace

void for_points_along(const Path& path, double tolerance_m, const std::function<void(const PathPoint&)>& visit) {
  for (std::size_t k = 0; k < path.rows.size(); ++k) {
    const PathEventRow& row = path.rows[k];
    visit(point_of(row));
    if (row.state != PathState::projectile || k + 1 == path.rows.size()) continue;
    const Arc arc(row, path.rows[k + 1]);
    const int pieces = arc.pieces(tolerance_m);
    for (int piece = 1; piece < pieces; ++piece) visit(arc.at(arc.duration() * piece / pieces));
  }
}

}  // namespace talus
