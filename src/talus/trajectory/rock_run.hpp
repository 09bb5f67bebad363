#pragma once
// One rock from release to rest, for callers that run several rocks at the same time. The run pauses where the rock
// glides, so that the glides of several rocks can be stepped together. follow_rock() (rock_path.hpp) runs one rock.

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
#include "talus/trajectory/touching.hpp"

namespace talus {

/// `Sink`: is told what happens to the rock (event.hpp). One that keeps the steps of glides has a function
/// glide_trace(), which returns the list that receives them, or null.
template <TerrainSurface Surface, class Sink = RockLog>
class RockRun {
 public:
  RockRun(const Scene<Surface>& scene, const Release& release, const Draws& draws, Sink& sink)
      : rock_(scene, release, draws, sink), orientation_(release.orientation), has_room_(release.has_room) {}
  /// Goes on from a state of the same rock.
  RockRun(const Scene<Surface>& scene, const Release& release, const RockState& from, const Draws& draws, Sink& sink)
      : rock_(scene, release, draws, sink), has_room_(true), is_released_(true) {
    static_cast<RockState&>(rock_) = from;
  }

  /// Why advance() returned.
  enum class Pause {
    gliding,  // along a facet: the caller takes the steps of glide(), then calls advance() again
    ended,
    stopped  // by `stop`, without an end; another run may go on from state()
  };
  /// Follows the rock until it glides or ends, or until a stop is requested (null: never).
  Pause advance(const StopScope* stop = nullptr);
  /// Between flights and legs.
  [[nodiscard]] const RockState& state() const { return rock_; }
  /// The glide of a rock that pauses in one.
  [[nodiscard]] Glide& glide() { return glide_->glide; }
  /// Takes one step of the glide; false if the glide has ended.
  bool step_glide();
  /// The list that receives the steps of the glide; null if the sink keeps none.
  [[nodiscard]] std::vector<GlideStep>* glide_trace() {
    if constexpr (requires { rock_.sink.glide_trace(); }) return rock_.sink.glide_trace();
    return nullptr;
  }
  [[nodiscard]] static GlideLaws glide_laws(const Laws& laws) { return {laws.stopped_velocity, laws.max_time}; }
  /// Follows the rock from release to rest, glides included.
  RockOutcome follow();
  /// Of a rock whose run has ended.
  [[nodiscard]] const RockOutcome& outcome() const { return rock_.outcome; }

 private:
  void release();
  void proceed();
  void end();
  void enter(Phase phase);
  void count_short_leg(double start);
  bool begin_glide();
  [[nodiscard]] bool has_ended() const { return std::holds_alternative<Ended>(rock_.phase); }

  TrackedRock<Surface, Sink> rock_;
  std::optional<GlideOnFacet> glide_;  // while the run pauses in one
  Orientation orientation_;            // at the release
  bool has_room_, is_released_ = false;
};

/// The life of a rock: from one phase to the next until it ends.
template <TerrainSurface Surface, class Sink>
auto RockRun<Surface, Sink>::advance(const StopScope* stop) -> Pause {
  constexpr unsigned stop_interval = 64;  // flights and legs between two looks at `stop`: well below a millisecond
  if (!std::exchange(is_released_, true)) {
    release();
  } else if (glide_) {
    end_glide(rock_, *glide_);
    glide_.reset();
    proceed();
  }
  for (unsigned passes = 1; !has_ended(); ++passes) {
    if (passes % stop_interval == 0 && stop != nullptr && stop->is_requested()) return Pause::stopped;
    if (begin_glide()) return Pause::gliding;
    proceed();
  }
  end();
  return Pause::ended;
}

/// One flight, or one leg along the ground, and the phase after it. A phase that is not handled here does not compile.
template <TerrainSurface Surface, class Sink>
void RockRun<Surface, Sink>::proceed() {
  struct Transition {
    TrackedRock<Surface, Sink>& rock;
    std::optional<NextPhase> operator()(const Flying& phase) const {
      return NextPhase{rock.has_forest ? fly_with_forests(rock, phase) : fly(rock, phase)};
    }
    std::optional<NextPhase> operator()(const Tumbling& phase) const {
      return NextPhase{rock.has_forest ? fly_with_forests(rock, phase) : fly(rock, phase)};
    }
    std::optional<NextPhase> operator()(Touching& phase) const { return take_step(rock, phase); }
    std::optional<NextPhase> operator()(OnFacet& phase) const { return take_leg(rock, phase); }
    std::optional<NextPhase> operator()(OnEdge& phase) const { return take_leg(rock, phase); }
    std::optional<NextPhase> operator()(InValley& phase) const { return take_leg(rock, phase); }
    std::optional<NextPhase> operator()(const Ended&) const { return std::nullopt; }
  };
  if (auto* valley = std::get_if<InValley>(&rock_.phase); valley != nullptr && !is_held(rock_, *valley)) {
    rock_.phase = leave_other_side(rock_, *valley);
  }
  const double start = rock_.motion.time;
  std::optional<NextPhase> next = std::visit(Transition{rock_}, rock_.phase);
  if (next && !next->is_same_stretch) return enter(std::move(next->phase));
  if (next) rock_.phase = std::move(next->phase);
  count_short_leg(start);
}

/// A rock that does not fit between floor and ceiling where it is released rests there.
template <TerrainSurface Surface, class Sink>
void RockRun<Surface, Sink>::release() {
  const Vec3 spin = rock_.motion.spin;
  if (rock_.body) rock_.motion.spin = spin_of_sphere(rock_.rock, *rock_.body, orientation_, spin);
  rock_.outcome.start = rock_.motion;
  rock_.outcome.max_kinetic_energy = rock_.kinetic_energy();
  if (rock_.body) rock_.tell(event::Turned{rock_.motion, *rock_.body, orientation_, spin});
  rock_.tell(event::Release{rock_.motion});
  if (!has_room_) return enter(Ended{EndReason::at_rest});
  if (rock_.body) return enter(Tumbling{orientation_, spin, rock_.motion.time});
  enter(Flying{});
}

/// A flight or a stretch along the ground begins, which counts as a step: the limit of steps, and rocks that do not
/// move on, are checked here.
template <TerrainSurface Surface, class Sink>
void RockRun<Surface, Sink>::enter(Phase phase) {
  rock_.phase = std::move(phase);
  rock_.stretch = {};
  if (has_ended()) return;
  if (rock_.steps++ >= rock_.laws.max_steps) {
    rock_.phase = Ended{EndReason::maximum_steps};
  } else if (rock_.progress.record(rock_.motion, rock_.reach); rock_.is_wedged()) {
    rock_.phase = come_to_rest(rock_);
  }
}

/// Legs of about a timestep are limited by the maximum time of a rock. A hundred shorter ones count as a step, so that
/// legs of no duration also reach a limit.
template <TerrainSurface Surface, class Sink>
void RockRun<Surface, Sink>::count_short_leg(double start) {
  constexpr std::uint32_t legs_per_step = 100;
  if (rock_.motion.time - start >= 0.5 * rock_.laws.timestep || ++rock_.short_legs < legs_per_step) return;
  rock_.short_legs = 0;
  if (rock_.steps++ >= rock_.laws.max_steps) rock_.phase = Ended{EndReason::maximum_steps};
}

template <TerrainSurface Surface, class Sink>
void RockRun<Surface, Sink>::end() {
  rock_.outcome.reason = std::get<Ended>(rock_.phase).reason;
  rock_.update_max_energy();
  rock_.outcome.max_bounce = rock_.body ? rock_.max_height : lowest_point(rock_.max_height, rock_.reach);
  rock_.outcome.end = rock_.motion;
  if (rock_.outcome.reason != EndReason::left_model) {
    if (const auto below = rock_.surface.ground_below(rock_.motion.position))
      rock_.outcome.ground = rock_.material_at(below->facet);
  }
  rock_.tell(event::End{rock_.motion});
}

template <TerrainSurface Surface, class Sink>
bool RockRun<Surface, Sink>::begin_glide() {
  const auto* facet = std::get_if<OnFacet>(&rock_.phase);
  if (facet == nullptr) return false;
  glide_ = prepare_glide(rock_, *facet);
  return glide_.has_value();
}

template <TerrainSurface Surface, class Sink>
bool RockRun<Surface, Sink>::step_glide() {
  const GlideLaws laws = glide_laws(rock_.laws);
  Glide& glide = glide_->glide;
  if (!try_step(laws, glide)) return false;
  if (auto* trace = glide_trace()) trace->push_back({glide.x, glide.y, glide.vx, glide.vy});
  return true;
}

template <TerrainSurface Surface, class Sink>
RockOutcome RockRun<Surface, Sink>::follow() {
  while (advance() == Pause::gliding) {
    while (step_glide()) {
    }
  }
  return outcome();
}

extern template class RockRun<Profile>;
extern template class RockRun<TriangleMesh>;
extern template class RockRun<RasterSurface>;

}  // namespace talus
