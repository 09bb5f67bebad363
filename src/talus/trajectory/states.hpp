#pragma once
// What a rock is doing: the states of its life. Each is a type that holds what that state knows and nothing else; what
// all have in common - where the rock is, how it moves - is in MovingRock. How a rock comes from one to the next stands
// in the file of the state that it leaves.

#include <optional>
#include <variant>

#include "talus/rocks/motion.hpp"
#include "talus/sliding/rolling.hpp"
#include "talus/sliding/supports.hpp"
#include "talus/terrain/contact.hpp"

namespace talus {

/// In the air, from where the rock is (flying.hpp).
struct Flying {
  SupportPlanes left;  // what it has just slid or rolled off
  /// Whether it slid until it flew: landing flat enough, it slides on without an impact.
  [[nodiscard]] bool hops() const { return left.count > 0; }
};

/// How the ground brakes what moves along it.
struct GroundFriction {
  double mu = 0;           // lumped mass: tangent of the friction angle
  ContactFriction sphere;  // rigid sphere
  double drag = 0;         // of soft ground and of trees, over mass and velocity [1/s]
};

/// What carries a rock: a facet; or an edge or a vertex, of which it is one of the facets that meet there.
struct Support {
  Vec3 normal;  // unit, out of the ground; at an edge or a vertex from there to the rock's centre
  FacetId facet;
};

/// A facet of this normal that the rock touches yet but has left: for the next bit of way it is not ahead.
struct LeftFacet {
  Vec3 normal;
};
/// Something of this normal that the rock touches, too - a facet that keeps striking it, a barrier against which its
/// spin drives it: the next leg goes along both.
struct Guide {
  Vec3 normal;
};
/// What a rock touches, for one leg, besides what carries it.
using Beside = std::variant<std::monostate, LeftFacet, Guide>;

/// On a facet: the lumped mass slides, the rigid sphere rolls or slips (on_facet.hpp).
struct OnFacet {
  Support on;
  GroundFriction friction;
  Beside beside;
};

/// A sphere on an edge or a vertex, about which it turns (on_edge.hpp).
struct OnEdge {
  Support on;
  GroundFriction friction;
  Beside beside;
};

/// In the line in which two supports meet, between which gravity holds the rock (in_valley.hpp). The first of them is
/// `other`, which the rock was on when it came to `on`.
struct InValley {
  Support on;
  bool is_on_facet;  // and not on an edge or a vertex of it
  GroundFriction friction;
  Support other;
  Valley valley;
};

struct Ended {
  EndReason reason;
};

using RockState = std::variant<Flying, OnFacet, OnEdge, InValley, Ended>;

/// What comes after a leg along the ground, where that is not more of the same.
struct NextState {
  RockState state;
  bool is_same_stretch = false;  // otherwise a stretch, flight or end begins, which counts as a step
};
[[nodiscard]] inline NextState within_stretch(RockState state) { return {std::move(state), true}; }

}  // namespace talus
