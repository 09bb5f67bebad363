#pragma once
// The record of a trajectory while it is computed. A log is reused for rock after rock, and does not allocate once its
// lists have grown.

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/rocks/attitude.hpp"
#include "talus/rocks/drag.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/rocks/parabola.hpp"
#include "talus/sliding/glide.hpp"
#include "talus/trajectory/event.hpp"

namespace talus {

struct PathRow {
  PathState state;
  Motion motion;
  std::optional<Orientation> orientation;  // of a rock with a shape
};

/// Of a rock with a shape: in how much of the time that it has flown, and how much of its angular momentum is along the
/// shortest of its principal axes: 1 for a wheel, 0 for a rod that turns about its length, 1/2 without preference.
struct SpinAxis {
  double flown = 0, along_short_axis = 0;  // [s]: of the flights; weighted with the share
  [[nodiscard]] double share() const { return flown > 0 ? along_short_axis / flown : 0; }
};

/// A part of a path with constant acceleration, as it was computed: a flight until something ends it, or the part of a
/// leg along the ground that the rock has covered. The pieces of a path join end to end, except for corrections of
/// rounding on the ground; the first begins at the release, the last ends where the path does. A piece may have no
/// duration.
///
/// On the ground, `path` gives positions; velocity and spin are linear in time between the piece's ends. (In a step of
/// a slide, `path` has the velocity of the step's end.)
///
/// In a flight with drag, `path` gives positions, and its parameter runs slower than time (rocks/drag.hpp): take
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
  void keep_pieces(bool keep) { keep_pieces_ = keep; }
  void clear() {
    rows.clear();
    turns.clear();
    pieces.clear();
    glide_steps.clear();
    first_step_ = 0;
    impact_places.clear();
    impacts.clear();
    hits.clear();
    passed_above.clear();
    ways = {};
    attitudes.clear();
    spin_axis = {};
    orientation_.reset();
  }

  // ---- what happens to the rock ----
  void operator()(const event::Release& release) { row(PathState::projectile, release.motion); }
  void operator()(const event::Turned& turned) {
    orientation_ = turned.orientation;
    const Vec3 momentum = turned.body.inertia.times(turned.orientation.to_body(turned.spin));
    const double norm = momentum.norm();
    short_share_ = norm > 0 ? std::abs(momentum.z()) / norm : 0;
    if (keep_pieces_) attitudes.push_back({turned.motion.time, turned.orientation, turned.spin});
  }
  void operator()(const event::Flight& flight) {
    const auto& [before, path, duration, drag] = flight;
    if (orientation_) {
      const double time = drag.time(duration);
      spin_axis.flown += time;
      spin_axis.along_short_axis += short_share_ * time;
    }
    ways.flown += (path.at(duration) - path.p).norm();
    if (keep_pieces_) pieces.push_back({path, duration, before.time, before.spin, false, {}, drag, {}, {}});
  }
  void operator()(const event::Leg& leg) {
    const auto& [before, after, path, duration, facet] = leg;
    ways.on_ground += (path.at(duration) - path.p).norm();
    if (!keep_pieces_) return;
    pieces.push_back(
        {path, duration, before.time, before.spin, true, facet, {}, {}, {before.velocity, after.velocity, after.spin}});
  }
  void operator()(const event::Glide& glide);
  void operator()(const event::Turn& turn) {
    if (keep_rows_) turns.push_back(turn.motion);
  }
  void operator()(const event::Contact& contact) {
    row(PathState::impact, contact.before);
    row(contact.then, contact.after);
    if (contact.impact == nullptr) return;
    if (keep_pieces_) impact_places.push_back(contact.impact->before.position);
    if (keep_impacts_) impacts.push_back(*contact.impact);
  }
  void operator()(const event::Bend& bend) { row(bend.then, bend.after); }
  void operator()(const event::AtBarrier& at) {
    hits.push_back(at.passage);
    row(PathState::barrier, at.passage.motion);
    if (at.after != nullptr) row(at.then, *at.after);
  }
  void operator()(const event::AtCollector& at) { hits.push_back(at.passage); }
  void operator()(const event::PassedAbove& above) { passed_above.push_back(above.passage); }
  void operator()(const event::NotPassedAbove& not_above) { take_back(passed_above, not_above.barrier); }
  void operator()(const event::End& end) { row(PathState::ended, end.motion); }
  /// The list that receives the steps of glides; null if they are not kept.
  [[nodiscard]] std::vector<GlideStep>* glide_trace() { return keep_pieces_ ? &glide_steps : nullptr; }

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
  std::vector<PathRow> rows;
  std::vector<Motion> turns;      // not rows of the path, but shown in pictures of it
  std::vector<PathPiece> pieces;  // like glide_steps and impact_places: only if requested
  std::vector<GlideStep> glide_steps;
  std::vector<Vec3> impact_places;
  std::vector<Impact> impacts;  // only if requested
  std::vector<Passage> hits;    // of barriers and collectors
  std::vector<Passage> passed_above;
  RockWays ways;
  std::vector<Attitude> attitudes;  // of a rock with a shape, in the order of time; only with pieces
  SpinAxis spin_axis;               // of a rock with a shape

 private:
  void row(PathState state, const Motion& motion) {
    if (keep_rows_) rows.push_back({state, motion, orientation_});
  }

  bool keep_rows_, keep_pieces_, keep_impacts_ = false;
  std::size_t first_step_ = 0;  // of the next glide
  std::optional<Orientation> orientation_;
  double short_share_ = 0;  // SpinAxis: of the momentum now
};

inline void RockLog::operator()(const event::Glide& glide) {
  ways.on_ground += glide.way;
  const std::size_t first = std::exchange(first_step_, glide_steps.size()), count = glide_steps.size() - first;
  if (!keep_pieces_ || count == 0) return;
  const auto velocity = [&](const GlideStep& step) { return step.vx * glide.down + step.vy * glide.aside; };
  const Motion& before = glide.before;
  pieces.push_back({{before.position, velocity(glide_steps[first]), Vec3{}},
                    static_cast<double>(count) * glide.timestep,
                    before.time,
                    before.spin,
                    true,
                    glide.facet,
                    {},
                    {first, count, glide.timestep, glide.down, glide.aside},
                    {before.velocity, velocity(glide_steps.back()), before.spin}});
}

}  // namespace talus
