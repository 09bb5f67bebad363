#pragma once
// A moving rock whose sink is told what happens to it (event.hpp). Private to trajectory/.

#include <optional>

#include "talus/trajectory/event.hpp"
#include "talus/trajectory/moving_rock.hpp"

namespace talus {

template <TerrainSurface Surface, class Sink>
class TrackedRock : public MovingRock<Surface> {
 public:
  TrackedRock(const Scene<Surface>& scene, const Release& release, const Draws& draws, Sink& told)
      : MovingRock<Surface>(scene, release, draws), sink(told) {}

  Sink& sink;

  template <class Event>
  void tell(const Event& event) {
    event::tell(sink, event);
  }
  /// An arrival at the ground, or where it ends: leave() completes it. Arrivals are the moments at which a rock is
  /// fastest.
  void arrive() {
    count_arrival();
    before_ = this->motion;
    impact_.reset();
  }
  /// The arrival is an impact.
  void note_impact(const Impact& impact) { impact_ = impact; }
  /// An arrival at a barrier: leave() completes it.
  void arrive(const Passage& passage) {
    count_arrival();
    at_barrier_ = passage;
  }
  /// The rock goes on from where it has arrived.
  void leave(PathState then) {
    if (at_barrier_) {
      tell(event::AtBarrier{*at_barrier_, &this->motion, then});
      at_barrier_.reset();
    } else {
      tell(event::Contact{before_, this->motion, then, impact_ ? &*impact_ : nullptr});
    }
  }
  /// It stays at the barrier at which it has arrived.
  void stop_at_barrier() {
    tell(event::AtBarrier{*at_barrier_, nullptr, PathState::ended});
    at_barrier_.reset();
  }
  /// It has covered the first `t` of a leg, from `before` to `after`, on a facet or one of its edges or vertices.
  void cover_leg(FacetId facet, const Parabola& leg, double t, const Motion& before, const Motion& after) {
    if (this->has_bumps) this->cover(facet, arc_length(leg, t));
    tell(event::Leg{before, after, leg, t, facet});
    this->update_max_height(facet, leg, t);
  }

 private:
  void count_arrival() {
    ++this->outcome.events;
    this->update_max_energy();
  }

  // The arrival that leave() completes.
  Motion before_;
  std::optional<Impact> impact_;
  std::optional<Passage> at_barrier_;
};

/// The ground falls away, or ends.
template <class Surface, class Sink, class GroundPhase>
[[nodiscard]] Phase take_off(TrackedRock<Surface, Sink>& rock, const GroundPhase& from, const LeftFacets& left = {}) {
  rock.arrive();
  rock.leave(PathState::projectile);
  return Flying{left, ground_so_far(rock, from)};
}

template <class Surface, class Sink>
[[nodiscard]] Phase leave_over_rim(TrackedRock<Surface, Sink>& rock, const Exit& exit) {
  rock.arrive();
  rock.leave(PathState::projectile);
  return Ended{reason_of(exit)};
}

}  // namespace talus
