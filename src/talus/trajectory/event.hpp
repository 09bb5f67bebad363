#pragma once
// What happens to a rock. Its run tells a sink: sink(event) is called for the kinds of event that the sink can be
// called with, and for no others. An event lives as long as that call.
//
// Events come in the order of time, and moves (flights, legs, glides) join end to end. Collectors that a rock reaches
// on a move, and barriers that it passes above, are told before the move.
//
// Checked by test/trajectory/event_test.cpp.

#include <concepts>
#include <cstdint>

#include "talus/barriers/passage.hpp"
#include "talus/core/id.hpp"
#include "talus/core/orientation.hpp"
#include "talus/rocks/drag.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/rocks/parabola.hpp"
#include "talus/rocks/shape.hpp"

namespace talus {

/// A rock strikes the ground.
struct Impact {
  Motion before, after;        // of its centre, with the velocity and spin before and after the impact law
  Vec3 normal, struck_normal;  // unit, out of the ground: of the facet (or from the edge or vertex to the centre), and
                               // with the tilt of the roughness
  std::uint32_t source = 0;    // the part of the terrain, as the surface's source() numbers it
  MaterialId ground;
};

namespace event {

struct Release {
  const Motion& motion;
};

/// How a rock with a shape is turned at the time of `motion`, and the spin with which it turns freely until it is told
/// again: before the release, every contact, arrival and end, after every departure from a barrier, and after every
/// step on the ground.
struct Turned {
  const Motion& motion;
  const Body& body;
  const Orientation& orientation;
  const Vec3& spin;  // of the body, in the frame of the terrain [rad/s]
};

/// A flight until something ends it, or a piece of one in a forest. `path`: of the centre; its parameter starts at 0
/// and goes to `duration`, and is time unless there is drag.
struct Flight {
  const Motion& before;
  const Parabola& path;
  double duration;  // [s]
  const LinearDrag& drag;
};

/// The part of a leg along the ground that the rock has covered. `facet`: one that carries it at the end.
struct Leg {
  const Motion &before, &after;
  const Parabola& path;  // of the centre, from 0 to `duration`
  double duration;       // [s]
  FacetId facet;
};

/// Many straight steps of a slide over one facet, of which the caller of the run has kept the list, if it wants them.
struct Glide {
  const Motion &before, &after;
  double way;                // straight from start to end [m]
  double timestep;           // [s]
  const Vec3 &down, &aside;  // unit: the directions of the steps in the facet
  FacetId facet;
};

/// A rock that slid uphill stands still before it slides back.
struct Turn {
  const Motion& motion;
};

/// The rock comes to ground, or to the end of the ground, and leaves it or moves along it. `impact`: null if it only
/// grazes the ground, or takes off where that falls away or ends.
struct Contact {
  const Motion &before, &after;  // after: as it goes on, without the velocity that the ground has taken away
  PathState then;
  const Impact* impact;
};

/// The rock moves on over ground that bends.
struct Bend {
  const Motion& after;
  PathState then;
};

/// The rock arrives at a barrier. `after`: null if it stops there.
struct AtBarrier {
  const Passage& passage;
  const Motion* after;
  PathState then;
};

/// Collectors do nothing to a rock.
struct AtCollector {
  const Passage& passage;
};

struct PassedAbove {
  const Passage& passage;
};

/// The last passage above the barrier was none: the rock has come down on it.
struct NotPassedAbove {
  BarrierId barrier;
};

struct End {
  const Motion& motion;
};

/// Whether anybody listens to a kind of event.
template <class Sink, class Event>
inline constexpr bool is_heard = std::invocable<Sink&, const Event&>;

/// Nobody listens.
struct NoSink {};

template <class Sink, class Event>
void tell(Sink& sink, const Event& event) {
  if constexpr (is_heard<Sink, Event>) sink(event);
}

}  // namespace event
}  // namespace talus
