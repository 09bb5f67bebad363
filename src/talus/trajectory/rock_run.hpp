#pragma once
// One rock from release to rest, for those who drive several rocks at the same time: it can be left where it glides and
// taken up again, so that glides are done together. follow_rock() (rock_path.hpp) follows one alone.

#include <optional>

#include "talus/core/stop.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"
#include "talus/trajectory/flying_with_forests.hpp"
#include "talus/trajectory/gliding.hpp"
#include "talus/trajectory/in_valley.hpp"
#include "talus/trajectory/on_edge.hpp"
#include "talus/trajectory/on_facet.hpp"

namespace talus {

template <TerrainSurface Surface>
class RockRun {
 public:
  RockRun(const Scene<Surface>& scene, const Release& release, const Draws& draws, RockLog& log)
      : rock_(scene, release, draws, log), has_room_(release.has_room) {}

  /// What a run has come to.
  enum class Pause {
    glides,  // along a facet; to go on, the steps of glide() are to be taken
    ended,
    stopped  // on request, on its way: it has no end, and is not to be gone on with
  };
  /// Follows the rock until it glides or ends, or until it is to stop; null: nobody asks for that.
  Pause go_on(const StopScope* stop = nullptr);
  [[nodiscard]] Glide& glide() { return glide_->glide; }
  /// Takes one of its steps; whether there was one to take.
  bool step_alone();
  /// Where the steps of the glide are wanted, the list for them.
  [[nodiscard]] std::vector<GlideStep>* glide_trace() {
    return rock_.log.keeps_pieces() ? &rock_.log.glide_steps : nullptr;
  }
  [[nodiscard]] static GlideLaws glide_laws(const Laws& laws) {
    return {laws.timestep, laws.stopped_velocity, laws.max_time};
  }
  /// From release to rest, alone.
  RockOutcome follow();
  /// Of a rock that has come to its end.
  [[nodiscard]] const RockOutcome& outcome() const { return rock_.outcome; }

 private:
  void begin(RockState state);
  void go_on_from_state();
  void take(std::optional<NextState> next, double start);
  bool begin_glide();

  MovingRock<Surface> rock_;
  RockState state_ = Flying{};
  std::optional<GlideOnFacet> glide_;  // under way
  std::int64_t steps_ = 0;             // flights and stretches so far, and a part of the legs
  std::int64_t short_legs_ = 0;        // so far
  bool has_room_, has_begun_ = false;
};

/// Each state knows what comes after it. A state that is not handled here does not compile.
template <TerrainSurface Surface>
void RockRun<Surface>::go_on_from_state() {
  struct Proceed {
    MovingRock<Surface>& rock;
    std::optional<NextState> operator()(const Flying& state) const {
      return NextState{rock.has_forest ? fly_where_forests_are(rock, state) : fly(rock, state)};
    }
    std::optional<NextState> operator()(OnFacet& state) const { return take_leg(rock, state); }
    std::optional<NextState> operator()(OnEdge& state) const { return take_leg(rock, state); }
    std::optional<NextState> operator()(InValley& state) const { return take_leg(rock, state); }
    std::optional<NextState> operator()(const Ended&) const { return std::nullopt; }
  };
  if (auto* valley = std::get_if<InValley>(&state_); valley != nullptr && !is_held(rock_, *valley)) {
    state_ = leave_other_side(rock_, *valley);
  }
  const double start = rock_.motion.time;
  take(std::visit(Proceed{rock_}, state_), start);
}

/// Legs that last as long as their timestep are limited by the time that a rock may take; of shorter ones a hundred
/// count as a step, so that what takes no time has an end as well.
template <TerrainSurface Surface>
void RockRun<Surface>::take(std::optional<NextState> next, double start) {
  constexpr std::int64_t legs_a_step = 100;
  if (next && !next->is_same_stretch) return begin(std::move(next->state));
  if (next) state_ = std::move(next->state);
  if (rock_.motion.time - start < 0.5 * rock_.laws.timestep && ++short_legs_ % legs_a_step == 0 &&
      steps_++ >= rock_.laws.max_steps) {
    state_ = Ended{EndReason::maximum_steps};
  }
}

/// What is checked before anything happens in a flight or a stretch along the ground.
template <TerrainSurface Surface>
void RockRun<Surface>::begin(RockState state) {
  state_ = std::move(state);
  rock_.stretch = {};
  if (std::holds_alternative<Ended>(state_)) return;
  if (steps_++ >= rock_.laws.max_steps) {
    state_ = Ended{EndReason::maximum_steps};
  } else if (rock_.progress.note(rock_.motion); rock_.is_wedged()) {
    state_ = come_to_rest(rock_);
  }
}

template <TerrainSurface Surface>
bool RockRun<Surface>::begin_glide() {
  const auto* facet = std::get_if<OnFacet>(&state_);
  if (facet == nullptr) return false;
  glide_ = prepare_glide(rock_, *facet);
  return glide_.has_value();
}

template <TerrainSurface Surface>
auto RockRun<Surface>::go_on(const StopScope* stop) -> Pause {
  if (!std::exchange(has_begun_, true)) {
    rock_.outcome.start = rock_.motion;
    rock_.outcome.max_kinetic_energy = rock_.kinetic_energy();
    rock_.note_row(PathState::projectile);
    begin(has_room_ ? RockState(Flying{}) : Ended{EndReason::at_rest});
  } else if (glide_) {
    end_glide(rock_, *glide_);
    glide_.reset();
    go_on_from_state();
  }
  constexpr unsigned often = 64;  // legs and flights between two looks: well below a millisecond
  for (unsigned passages = 1; !std::holds_alternative<Ended>(state_); ++passages) {
    if (passages % often == 0 && stop != nullptr && stop->is_requested()) return Pause::stopped;
    if (begin_glide()) return Pause::glides;
    go_on_from_state();
  }
  rock_.outcome.reason = std::get<Ended>(state_).reason;
  rock_.note_energy();
  rock_.outcome.end = rock_.motion;
  rock_.note_row(PathState::ended);
  return Pause::ended;
}

template <TerrainSurface Surface>
bool RockRun<Surface>::step_alone() {
  const GlideLaws laws = glide_laws(rock_.laws);
  Glide& glide = glide_->glide;
  if (!try_step(laws, glide)) return false;
  if (auto* trace = glide_trace()) trace->push_back({glide.x, glide.y, glide.vx, glide.vy});
  return true;
}

template <TerrainSurface Surface>
RockOutcome RockRun<Surface>::follow() {
  while (go_on() == Pause::glides) {
    while (step_alone()) {
    }
  }
  return outcome();
}

extern template class RockRun<Profile>;
extern template class RockRun<TriangleMesh>;
extern template class RockRun<RasterSurface>;

}  // namespace talus
