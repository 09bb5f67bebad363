#pragma once
// The record of a trajectory while it is computed. A log is reused for rock after rock, and does not allocate once its
// lists have grown.

#include <cstdint>
#include <vector>

#include "talus/barriers/passage.hpp"
#include "talus/core/id.hpp"
#include "talus/flight/drag.hpp"
#include "talus/flight/parabola.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/sliding/glide.hpp"

namespace talus {

struct PathRow {
  PathState state;
  Motion motion;
};

/// A part of a path with constant acceleration, as it was computed: a flight until something ends it, or the part of a
/// leg along the ground that the rock has covered. The pieces of a path join end to end, except for corrections of
/// rounding on the ground; the first begins at the release, the last ends where the path does. A piece may have no
/// duration.
///
/// On the ground, `path` gives positions; velocity and spin are linear in time between the piece's ends. (In a step of
/// a slide, `path` has the velocity of the step's end.)
///
/// In a flight with drag, `path` gives positions, and its parameter runs slower than time (flight/drag.hpp): take
/// velocities and times from the piece, not from its path.
struct PathPiece {
  Parabola path;          // of the centre; the parameter starts at 0, and is time unless there is drag
  double duration = 0;    // in that parameter [s]
  double start_time = 0;  // since release [s]
  Vec3 spin;              // at its start; constant in flight and in a slide's steps [rad/s]
  bool on_ground = false;
  FacetId facet;  // on the ground: the one that carries the rock at the end, or one of those at the edge or vertex
  LinearDrag drag;

  /// Of a glide: straight steps of equal duration, which the log keeps in two directions on the facet.
  struct Steps {
    std::size_t first = 0, count = 0;  // in RockLog::glide_steps
    double timestep = 0;               // [s]
    Vec3 down, aside;                  // unit; steps are relative to the start of the piece
  };
  Steps steps;

  /// On the ground.
  struct Ends {
    Vec3 start_velocity, end_velocity;  // [m/s]
    Vec3 end_spin;                      // [rad/s]
  };
  Ends ends;

  [[nodiscard]] Vec3 velocity(double s) const {
    return on_ground ? between(ends.start_velocity, ends.end_velocity, s) : drag.velocity(path, s);
  }
  [[nodiscard]] Vec3 spin_at(double s) const { return on_ground ? between(spin, ends.end_spin, s) : spin; }
  /// Since release [s].
  [[nodiscard]] double time(double s) const { return start_time + drag.time(s); }

 private:
  /// Equal to `start` and `end`, bit for bit, at the piece's ends.
  [[nodiscard]] Vec3 between(const Vec3& start, const Vec3& end, double s) const {
    const double share = duration > 0 ? s / duration : 0;
    return (1 - share) * start + share * end;
  }
};

/// A rock strikes the ground.
struct Impact {
  Motion before, after;        // of its centre, with the velocity and spin before and after the impact law
  Vec3 normal, struck_normal;  // unit, out of the ground: of the facet (or from the edge or vertex to the centre), and
                               // with the tilt of the roughness
  std::uint32_t source = 0;    // the part of the terrain, as the surface's source() numbers it
  MaterialId ground;
};

/// How far a rock has come, straight from end to end of each flight, each leg, and each glide over a facet [m].
struct RockWays {
  double flown = 0;
  double on_ground = 0;  // slid or rolled
};

class RockLog {
 public:
  explicit RockLog(bool keep_rows, bool keep_pieces = false) : keep_rows_(keep_rows), keep_pieces_(keep_pieces) {}

  void keep_rows(bool keep) { keep_rows_ = keep; }
  void keep_impacts(bool keep) { keep_impacts_ = keep; }
  [[nodiscard]] bool keeps_impacts() const { return keep_impacts_; }
  void keep_pieces(bool keep) { keep_pieces_ = keep; }
  [[nodiscard]] bool keeps_pieces() const { return keep_pieces_; }
  void clear() {
    rows.clear();
    turns.clear();
    pieces.clear();
    glide_steps.clear();
    impact_places.clear();
    impacts.clear();
    hits.clear();
    passed_above.clear();
    ways = {};
  }
  void row(PathState state, const Motion& motion) {
    if (keep_rows_) rows.push_back({state, motion});
  }
  /// A rock that slid uphill stands still before it slides back: not a row of the path, but shown in pictures of it.
  void turn(const Motion& motion) {
    if (keep_rows_) turns.push_back(motion);
  }
  /// A flight that starts with `motion` and covers `duration` of `path`.
  void flight(const Parabola& path, double duration, const Motion& motion, const LinearDrag& drag = {}) {
    ways.flown += (path.at(duration) - path.p).norm();
    if (keep_pieces_) pieces.push_back({path, duration, motion.time, motion.spin, false, {}, drag, {}, {}});
  }
  /// A leg along the ground, from `motion` to `then` in `duration` along `path`, on `facet`.
  void leg(const Parabola& path, double duration, const Motion& motion, const Motion& then, FacetId facet) {
    ways.on_ground += (path.at(duration) - path.p).norm();
    if (!keep_pieces_) return;
    pieces.push_back(
        {path, duration, motion.time, motion.spin, true, facet, {}, {}, {motion.velocity, then.velocity, then.spin}});
  }
  /// A piece of no duration on the ground: the motion right after an impact, part of which the ground takes away.
  void moment(const Motion& motion, FacetId facet) { leg({motion.position, Vec3{}, Vec3{}}, 0, motion, motion, facet); }
  /// A glide that starts with `motion` and leads `way` far: the steps of the list from `first` to its end.
  void glide(const Motion& motion, double way, std::size_t first, double timestep, const Vec3& down, const Vec3& aside,
             FacetId facet) {
    ways.on_ground += way;
    const std::size_t count = glide_steps.size() - first;
    if (!keep_pieces_ || count == 0) return;
    const auto velocity = [&](const GlideStep& step) { return step.vx * down + step.vy * aside; };
    pieces.push_back({{motion.position, velocity(glide_steps[first]), Vec3{}},
                      static_cast<double>(count) * timestep,
                      motion.time,
                      motion.spin,
                      true,
                      facet,
                      {},
                      {first, count, timestep, down, aside},
                      {motion.velocity, velocity(glide_steps.back()), motion.spin}});
  }
  /// One step of a glide as a piece.
  [[nodiscard]] PathPiece step_of(const PathPiece& glide, std::size_t number) const {
    const auto& [first, count, timestep, down, aside] = glide.steps;
    const GlideStep& step = glide_steps[first + number];
    const Vec3 velocity = step.vx * down + step.vy * aside;
    Vec3 start = glide.path.p, start_velocity = glide.ends.start_velocity;
    if (number > 0) {
      const GlideStep& before = glide_steps[first + number - 1];
      start += before.x * down + before.y * aside;
      start_velocity = before.vx * down + before.vy * aside;
    }
    return {{start, velocity, Vec3{}},
            timestep,
            glide.start_time + static_cast<double>(number) * timestep,
            glide.spin,
            true,
            glide.facet,
            {},
            {},
            {start_velocity, velocity, glide.spin}};
  }
  /// Calls visit(piece) for each piece; for a glide, for each of its steps.
  template <class Visit>
  void for_each_piece(Visit&& visit) const {
    for (const PathPiece& piece : pieces) {
      if (piece.steps.count == 0) visit(piece);
      double time = piece.start_time;
      for (std::size_t k = 0; k < piece.steps.count; ++k, time += piece.steps.timestep) {
        PathPiece step = step_of(piece, k);
        step.start_time = time;  // added up as the rock's time is
        visit(step);
      }
    }
  }
  /// The rock strikes the ground; `position` of its centre.
  void impact_place(const Vec3& position) {
    if (keep_pieces_) impact_places.push_back(position);
  }

  /// Completes the last impact.
  void rebound(const Motion& motion) {
    if (keep_impacts_) impacts.back().after = motion;
  }

  std::vector<PathRow> rows;
  std::vector<Motion> turns;
  std::vector<PathPiece> pieces;  // like glide_steps and impact_places: only if requested
  std::vector<GlideStep> glide_steps;
  std::vector<Vec3> impact_places;
  std::vector<Impact> impacts;  // only if requested
  std::vector<Passage> hits;    // of barriers and collectors
  std::vector<Passage> passed_above;
  RockWays ways;

 private:
  bool keep_rows_, keep_pieces_, keep_impacts_ = false;
};

}  // namespace talus
