#pragma once
// The phases of a rock's life. Each is a type with the data of that phase alone; what all phases share - position,
// velocity, spin - is in MovingRock. The transition out of a phase is in the file of that phase.

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "talus/core/id.hpp"
#include "talus/core/orientation.hpp"
#include "talus/rocks/motion.hpp"
#include "talus/sliding/rolling.hpp"

namespace talus {

/// Friction and drag of the ground on a rock that moves along it.
struct GroundFriction {
  double mu = 0;           // lumped mass: tangent of the friction angle
  ContactFriction sphere;  // rigid sphere
  double drag = 0;         // of soft ground and trees: force over mass and velocity [1/s]
};

/// The ground along which a rock moved until now. If it meets the next ground at a small angle, it moves on along it,
/// with the same friction if the material is the same.
struct GroundSoFar {
  GroundFriction friction;
  MaterialId material;
};

/// The facets that a rock has just slid or rolled off.
struct LeftFacets {
  std::array<FacetId, 2> facet;
  std::uint32_t count = 0;

  void add(FacetId of) { facet[count++] = of; }
};

/// In the air (flying.hpp).
struct Flying {
  LeftFacets left;
  std::optional<GroundSoFar> ground{};  // it moved along this until it took off
};

/// What carries a rock: a facet, an edge or a vertex.
struct Support {
  Vec3 normal;    // unit, out of the ground; at an edge or a vertex from there to the rock's centre
  FacetId facet;  // at an edge or a vertex: one of the facets that meet there
};

/// The rock has left a facet of this normal, but still touches it: the next short leg does not collide with it.
struct LeftFacet {
  Vec3 normal;
};
/// The rock also touches something of this normal - a facet that it strikes again and again, a barrier that its spin
/// drives it against: the next leg runs along both.
struct Guide {
  Vec3 normal;
};
/// What a rock touches in addition to its support, for one leg.
using SideContact = std::variant<std::monostate, LeftFacet, Guide>;

/// One support carries the rock.
struct OnSupport {
  Support on;
  GroundFriction friction;
  SideContact side_contact;
};

/// On a facet: the lumped mass slides, the rigid sphere rolls or slips (on_facet.hpp).
struct OnFacet : OnSupport {};

/// A sphere that turns about an edge or a vertex (on_edge.hpp).
struct OnEdge : OnSupport {};

/// Held by gravity between two supports, so that it can only move along the line in which they meet (in_valley.hpp).
/// The rock was on `other` when it came to `on`.
struct InValley {
  Support on, other;
  GroundFriction friction;
  bool is_on_facet;  // `on` is a facet, not one of its edges or vertices
};

/// A rock with a shape in the air (tumbling.hpp).
struct Tumbling {
  Orientation orientation;
  Vec3 spin;                // of the body; that of Motion is the one that tables know (spin_of_sphere)
  double since = 0;         // when it had these: the time of Motion [s]
  std::uint32_t quick = 0;  // impacts in a row, each right after the last
};

/// What held a corner of a rock with a shape in a step, over the rock's mass and the step's duration [m/s2]: near to
/// what holds it in the next.
struct CornerHold {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::uint32_t corner = none;
  std::array<float, 3> pull{};
};

/// A rock with a shape on the ground (touching.hpp).
struct Touching {
  Orientation orientation;
  Vec3 spin;  // as in Tumbling
  GroundFriction friction;
  MaterialId ground;
  double apart = 0, quiet = 0;  // how long nothing has pushed it, and how long it has hardly moved [s]
  std::array<CornerHold, 4> holds{};
  std::array<float, 3> moment{};  // in that step, over mass and duration [m2/s2]
};

struct Ended {
  EndReason reason;
};

using Phase = std::variant<Flying, OnFacet, OnEdge, InValley, Tumbling, Touching, Ended>;

/// The phase after a leg along the ground, if it has changed.
struct NextPhase {
  Phase phase;
  bool is_same_stretch = false;  // if false, a flight or a new stretch along the ground begins, which counts as a step
};
[[nodiscard]] inline NextPhase within_stretch(Phase phase) { return {std::move(phase), true}; }

}  // namespace talus
