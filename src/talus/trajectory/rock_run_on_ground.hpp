#pragma once
// The part of RockRun in which the rock stays on the ground. Included by rock_run.hpp only.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

/// The impact left the rock on the ground.
template <class Surface>
auto RockRun<Surface>::enter_ground(const Contact& contact, const GroundDraw& draw, const Material& material, double rt)
    -> Phase {
  OnGround& phase = on_ground_;
  phase.normal = contact.normal;
  phase.facet = contact.facet;
  phase.on_facet = contact.feature == Feature::facet;
  phase.other_normal.reset();
  phase.is_guided = false;
  phase.valley.reset();
  draw_friction(phase, draw, material, rt);
  constexpr double here = 1e-5;  // [m]: contacts so near each other are one contact with both facets
  const bool struck_here = (motion_.position - last_strike_).squaredNorm() < here * here;
  if (struck_here && last_normal_.dot(phase.normal) < 1 - 1e-9) {
    phase.valley = caught_between(laws_.gravity, last_normal_, phase.normal, motion_.velocity, leaving_speed_);
    if (phase.valley) {
      phase.other_normal = last_normal_;
      phase.other_facet = last_facet_;
    } else if (gets_nowhere()) {
      // What drives it from one to the other is not gravity: friction, or a third contact. It goes along both.
      phase.other_normal = last_normal_;
      phase.is_guided = true;
    }
  }
  remember_strike(phase.normal, phase.facet);

  // RocFall3 lists the small normal velocity in the row in which a slide begins, RocFall2 does not (tables,
  // row 14). Along the slope they agree, and that is what slides.
  const Vec3 along = tangential(motion_.velocity, phase.normal);
  if (laws_.model == RockModel::lumped_mass && laws_.sliding == SlidingMethod::stepped) {
    log_.row(PathState::sliding, motion_);
    log_.moment(motion_);
    motion_.velocity = along;
  } else {
    motion_.velocity = along;
    log_.row(contact_state(phase.normal), motion_);
  }
  if (phase.valley) {
    share_friction(phase);
    go_along_valley(phase);
  } else if (phase.is_guided) {
    const Vec3 e = phase.normal.cross(*phase.other_normal).normalized();
    motion_.velocity = motion_.velocity.dot(e) * e;
  }
  return Phase::on_ground;
}

template <class Surface>
void RockRun<Surface>::draw_friction(OnGround& phase, const GroundDraw& draw, const Material& material, double rt) {
  phase.drag = material.ground_drag;
  if (material.has_forest() && reach_ < material.forest_height) phase.drag += material.forest_drag / rock_.mass;
  if (laws_.model == RockModel::rigid_sphere) {
    phase.friction = {draw.dynamic_friction(material), draw.rolling_friction(material)};
    return;
  }
  switch (laws_.friction_source) {
    case FrictionSource::material:
      if (const double angle = draw.friction_angle(material); angle != angle_) {
        angle_ = angle;
        tangent_ = std::tan(angle);
      }
      phase.mu = tangent_;
      break;
    case FrictionSource::tangential_restitution:
      phase.mu = rt > 0 ? (1 - rt) / rt : 1e300;
      break;
    case FrictionSource::zero:
      phase.mu = 0;
      break;
  }
}

/// For the ground that carries the rock now.
template <class Surface>
void RockRun<Surface>::redraw_friction(OnGround& phase) {
  const Material& material = ground_[material_at(phase.facet)];
  const GroundDraw draw = draw_at(phase.facet);
  draw_friction(phase, draw, material, draw.restitution(material)[1]);
  if (phase.valley) share_friction(phase);
}

template <class Surface>
PathState RockRun<Surface>::contact_state(const Vec3& normal) const {
  if (laws_.model == RockModel::lumped_mass) return PathState::sliding;
  const Vec3 slip = slip_velocity(motion_.velocity, motion_.spin, normal, rock_.radius);
  return slip.norm() < 1e-6 ? PathState::rolling : PathState::sliding;
}

template <class Surface>
Footing RockRun<Surface>::footing(const OnGround& phase) {
  if (phase.valley) return phase.valley->footing;
  Footing footing = Footing::on_plane(laws_.gravity, phase.normal);
  if (is_on_edge(phase)) footing.pressure = std::max(0.0, pressure_on_edge(phase.facet, phase.normal));
  return footing;
}

template <class Surface>
Leg RockRun<Surface>::next_leg(const OnGround& phase, const Footing& footing) const {
  const double longest = longest_leg(phase, footing);
  if (phase.drag == 0) return undragged_leg(phase, footing, longest);
  const bool is_sphere = laws_.model == RockModel::rigid_sphere;
  const bool rolls = is_sphere && contact_state(phase.normal) == PathState::rolling;
  const RollingPlane plane = rolling_plane(phase);
  const double friction = footing.pressure * (rolls       ? plane.friction.rolling
                                              : is_sphere ? plane.friction.dynamic
                                                          : phase.mu);
  const double speed = motion_.velocity.norm();
  const Vec3 net = footing.pull - friction / std::max(speed, 1e-300) * motion_.velocity;
  const double timestep = dragged_timestep(phase.drag, longest, net, motion_.velocity);
  const double share = rolls ? rolling_share(plane.rock) : 1;
  return cut_short(undragged_leg(phase, dragged(footing, motion_.velocity, phase.drag, timestep, share), timestep),
                   timestep);
}

template <class Surface>
Leg RockRun<Surface>::undragged_leg(const OnGround& phase, const Footing& footing, double timestep) const {
  if (laws_.model == RockModel::lumped_mass) {
    const auto law = laws_.sliding == SlidingMethod::stepped ? stepped_leg : closed_form_leg;
    return law(motion_.position, motion_.velocity, motion_.spin, footing, phase.mu, timestep);
  }
  const auto [n, rock, friction] = rolling_plane(phase);
  return rolling_leg(motion_.position, motion_.velocity, motion_.spin, n, footing, rock, friction, timestep);
}

/// Whether the rock has come to its end here.
template <class Surface>
bool RockRun<Surface>::rests(const OnGround& phase, const Footing& footing) const {
  const double speed = motion_.velocity.norm();
  const bool to_the_end = laws_.model == RockModel::lumped_mass && laws_.sliding == SlidingMethod::closed_form;
  if (speed > laws_.stopped_velocity) return false;
  if (laws_.model == RockModel::rigid_sphere && phase.friction.dynamic > 0) {
    // Friction drives a sphere that stands and spins.
    const Vec3 slip = slip_velocity(motion_.velocity, motion_.spin, phase.normal, rock_.radius);
    if (slip.norm() > laws_.stopped_velocity) return false;
  }
  const auto held = [&](Footing f) {
    // What drag would keep slower than where a rock may stop, does not move.
    const double crawl = phase.drag * laws_.stopped_velocity, pull = f.pull.norm();
    if (crawl > 0) f.pull *= std::max(0.0, 1 - crawl / std::max(pull, 1e-300));
    return laws_.model == RockModel::rigid_sphere ? holds(f, rolling_plane(phase).friction) : holds(f, phase.mu);
  };
  if (held(footing)) return !to_the_end || speed < 1e-9;  // the closed form slides until it stands
  // In a corner of several facets it may be held where one of them alone would not.
  Supports supports;
  supports.add(phase.normal);
  surface_.supports(motion_.position, reach_, 1e-6, [&](const Vec3& n, const Vec3& middle, double, FacetId) {
    // A point on a ridge touches both its sides and is caught between neither: only what rises from here counts.
    const bool rises = (middle - motion_.position).dot(phase.normal) > 0;
    if (reach_ > 0 || rises) supports.add(n);
  });
  return supports.count() > 1 && held(footing_on(laws_.gravity, supports));
}

template <class Surface>
void RockRun<Surface>::advance_along(const Leg& leg, double t) {
  motion_.position = leg.path.at(t);
  motion_.time += t;
  if (t >= leg.duration) {
    motion_.velocity = leg.end_velocity;
    motion_.spin = leg.end_spin;
    return;
  }
  if (!std::isfinite(leg.duration)) {  // a closed form; spin does not change
    motion_.velocity = leg.path.velocity(t);
    return;
  }
  // A step that is cut short changes the velocity by its share only: it must not gain speed for ground not covered.
  const double share = t / leg.duration;
  const Vec3 reached = motion_.velocity + share * (leg.end_velocity - motion_.velocity);
  // A step moves along its last velocity. The rock leaves it that way, so that it does not seem to come back over an
  // edge that it has just crossed.
  const Vec3 way = leg.path.velocity(t);
  motion_.velocity = way.squaredNorm() > 0 ? Vec3(reached.norm() * way.normalized()) : reached;
  motion_.spin += share * (leg.end_spin - motion_.spin);
}

/// Rounding must not lift a rock off its facet, or off the bottom of its valley, or press it in, leg after leg.
template <class Surface>
void RockRun<Surface>::stand_on(const OnGround& phase) {
  if (!phase.on_facet) return;
  const auto height = [&](const Vec3& n, const Vec3& point) { return n.dot(motion_.position - point) - reach_; };
  const Vec3& n = phase.normal;
  Vec3 shift = -height(n, outline_of(phase.facet).point) * n;
  if (phase.valley) {
    if (!carries(phase.other_facet, *phase.other_normal)) return;
    // To where the rock touches both planes, the shortest way.
    const Vec3& m = *phase.other_normal;
    const Vec3 across = tangential(m, n);  // towards the first plane's side of the second one, in the first plane
    shift -= (height(m, surface_.point_of(phase.other_facet)) + m.dot(shift)) / across.squaredNorm() * across;
  }
  // A sphere may have sunk in by more than rounding: what lifting it costs, it pays, and without the means it stays.
  const double work = shift.norm() > contact_slack ? -rock_.mass * shift.dot(laws_.gravity) : 0;
  if (work > 0) {
    const double energy = kinetic_energy();
    if (energy <= work) return;
    const double kept = std::sqrt(1 - work / energy);
    motion_.velocity *= kept;
    motion_.spin *= kept;
  }
  motion_.position += shift;
}

/// The first side of a facet that a leg crosses outwards before `t`, which becomes the time; the leg comes to the facet
/// at the time `from`.
template <class Surface>
std::optional<OutlineEdge> RockRun<Surface>::side_crossed(const OnGround& phase, FacetId facet, const Parabola& leg,
                                                          double& t, double from) {
  const Outline& outline = outline_of(facet);
  std::optional<int> crossed_side;
  for (int k = 0; k < outline.edge_count; ++k) {
    const OutlineEdge& side = outline.edges[static_cast<std::size_t>(k)];
    // The bottom of a valley is a side of both its facets; along it there is no crossing it.
    if (phase.valley && std::abs(side.inward.dot(phase.valley->direction)) < 1e-9) continue;
    const double distance = (leg.p - side.point).dot(side.inward);
    const double speed = leg.v.dot(side.inward), acceleration = leg.a.dot(side.inward);
    // Most legs are short and stay far from all sides.
    const double nearest = distance + std::min(speed, 0.0) * t + 0.5 * std::min(acceleration, 0.0) * t * t;
    if (nearest > 0) continue;
    auto crossed = falling_root(distance, speed, acceleration, 1e300);
    if (crossed && *crossed < from) {  // a bent way may have crossed the line of the side before it came here
      crossed = falling_root(distance + from * (speed + 0.5 * from * acceleration), speed + from * acceleration,
                             acceleration, 1e300);
      if (crossed) *crossed += from;
    }
    if (crossed && *crossed < t) {
      t = *crossed;
      crossed_side = k;
    }
  }
  return crossed_side ? std::optional(outline.edges[static_cast<std::size_t>(*crossed_side)]) : std::nullopt;
}

/// The edge at which a leg comes to the end of its plane, if that is before `t`, which becomes the time; on the way the
/// phase is moved from facet to facet of one plane and one material, as if there were no edges between them.
template <class Surface>
std::optional<OutlineEdge> RockRun<Surface>::edge_ahead(OnGround& phase, const Parabola& leg, double& t) {
  if (phase.valley) {
    auto side = side_crossed(phase, phase.facet, leg, t);
    if (carries(phase.other_facet, *phase.other_normal)) {
      if (auto other = side_crossed(phase, phase.other_facet, leg, t)) side = other;
    }
    return side;
  }
  constexpr int most_facets_a_leg = 1000;  // then the leg ends; what turns in circles at a vertex, a little beyond it
  const Vec3 plane = phase.normal;
  double t_edge = 0;
  for (int facets = 0; facets < most_facets_a_leg; ++facets) {
    const double from = std::exchange(t_edge, t);
    const auto edge = side_crossed(phase, phase.facet, leg, t_edge, from);
    if (!edge) return std::nullopt;
    const bool goes_on = edge->beyond && plane.dot(outline_of(*edge->beyond).normal) > 1 - same_plane &&
                         material_at(phase.facet) == material_at(*edge->beyond);
    if (!goes_on) {
      t = t_edge;
      return edge;
    }
    phase.facet = *edge->beyond;
    phase.normal = outline_of(phase.facet).normal;
  }
  constexpr double beyond_it = 1e-6;  // [m]
  t = std::min(t, std::max(t_edge, time_for_way(beyond_it, leg.v.norm(), leg.a.norm())));
  return std::nullopt;
}

/// Whether a rock that moves along the ground at `velocity` goes on over a facet as if it were the one it is on.
template <class Surface>
bool RockRun<Surface>::is_level(const Vec3& n, const Vec3& velocity) const {
  constexpr double level = 2e-6;  // sine of an angle a little above that of same_plane, so that nothing lies between
  return std::abs(velocity.dot(n)) <= level * velocity.norm() && laws_.gravity.dot(n) < 0;
}

/// Whether a rock that slides, or has slid until a moment ago, only grazes a facet, so that it is not struck and slides
/// on. (CRSP takes a share of the speed along the ground however flat an impact is: over a bend in many facets a slide
/// would lose all of it. What a sphere loses tends to nothing by its own law.)
template <class Surface>
bool RockRun<Surface>::grazes(const Vec3& n, const Vec3& velocity) const {
  const double into = -velocity.dot(n);
  return laws_.model == RockModel::lumped_mass && into >= 0 && into < laws_.grazing * velocity.norm() &&
         laws_.gravity.dot(n) < 0;
}

/// A lumped mass grazes the ground: it keeps nothing of what leads into it, and the impulse of that has its friction.
template <class Surface>
void RockRun<Surface>::settle_onto(const Vec3& n, double mu) {
  const double into = -motion_.velocity.dot(n);
  const Vec3 along = tangential(motion_.velocity, n);
  motion_.velocity = std::max(0.0, 1 - mu * into / std::max(along.norm(), 1e-300)) * along;
}

/// One leg; gives what comes after it, or nothing where the rock goes on as before.
template <class Surface>
auto RockRun<Surface>::move_along(OnGround& phase) -> Next {
  if (phase.valley && !is_held_in_valley(phase)) end_valley(phase);
  const Footing footing = this->footing(phase);
  note_progress(std::min(1.0, laws_.timestep / 0.01));
  if (rests(phase, footing) || is_wedged()) return come_to_rest();
  if (motion_.time >= laws_.max_time) return end(EndReason::maximum_time);
  const bool still = motion_.velocity.squaredNorm() == 0;
  if (still && std::exchange(stretch_.has_turned, true) == false) log_.turn(motion_);
  Leg leg = next_leg(phase, footing);
  double t = std::min(leg.duration, laws_.max_time - motion_.time);
  const LeftPlanes on = carrying(phase);
  if (phase.other_normal && !phase.valley) {
    if (phase.is_guided) {
      leg = guided(leg, phase.normal.cross(*phase.other_normal).normalized());
    } else {
      constexpr double past_the_end = 1e-3;  // how far it goes before that facet counts again [m]
      t = std::min(t, time_for_way(past_the_end, motion_.velocity.norm(), leg.path.a.norm()));
    }
    phase.other_normal.reset();
    phase.is_guided = false;
  }

  // What cuts the leg short: the facet's outline, other ground ahead of a sphere, a barrier; in this order at ties.
  std::optional<OutlineEdge> edge = phase.on_facet ? edge_ahead(phase, leg.path, t) : std::nullopt;
  std::optional<Contact> ahead;
  if (reach_ > 0) {
    ahead = surface_.first_contact_on_leg(leg.path, reach_, t, on);
    if (ahead) {
      t = ahead->t;
      edge.reset();
    }
  }
  const auto rim = rim_ahead(leg.path, t);
  if (rim) {
    t = rim->t;
    edge.reset();
    ahead.reset();
  }
  bool met = false;
  while (const auto crossing = next_crossing(leg.path, t)) {
    const Motion before = motion_;
    advance_along(leg, crossing->t);
    if (crossing->above) {  // whose foot lies under the ground here
      pass_above(*crossing, std::exchange(motion_, before));
      continue;
    }
    const Motion arrived = motion_;
    const AtBarrier then = meet_barrier(*crossing, motion_.time, footing.pull, &phase);
    if (then != AtBarrier::untouched) note_leg(leg.path, crossing->t, before, arrived);
    if (then == AtBarrier::held) return end(EndReason::stopped_by_barrier);
    met = then == AtBarrier::goes_on;
    if (met) break;
    motion_ = before;
  }
  if (met) {
    motion_.velocity = kept_on_ground(phase, motion_.velocity);
    log_.row(contact_state(phase.normal), motion_);
    return Phase::on_ground;  // a stretch of its own, which counts
  }

  const bool over_edge = is_on_edge(phase) && !rim && !ahead;
  const Motion before = motion_;
  advance_along(leg, t);
  const bool stays = !over_edge || settle_over_edge(phase);
  // Over an edge the way is bent to where the sphere has come.
  if (over_edge && t > 0) leg.path.a = 2 / (t * t) * (motion_.position - leg.path.p - t * leg.path.v);
  note_leg(leg.path, t, before, motion_);
  note_energy();
  if (rim) return leave_over_rim(rim->exit);
  stand_on(phase);
  if (ahead) {
    if (!phase.valley) remember_strike(phase.normal, phase.facet);
    return strike(*ahead);
  }
  if (edge) return leave_facet(phase, *edge);
  if (!stays) return take_off();
  if (!phase.on_facet && phase.valley) {
    // Between an edge and something else: after a while it is in the air again, if barely. (Not after a leg: where slip
    // ends at once and rolling begins, that would be for ever.)
    stretch_.past_edge += t;
    const double while_ = std::min(laws_.timestep, time_for_way(edge_step * reach_, motion_.velocity.norm(), 0));
    if (stretch_.past_edge >= 0.5 * while_) return take_off();
  }
  return std::nullopt;
}

/// What lies in the planes that carry the rock, or touches it at the edge that does, is not ahead.
template <class Surface>
LeftPlanes RockRun<Surface>::carrying(const OnGround& phase) {
  LeftPlanes on;
  if (phase.other_normal)
    on = {phase.normal, *phase.other_normal};
  else if (phase.on_facet)
    on = LeftPlanes(phase.normal);
  if (is_on_edge(phase)) on.turn_about(motion_.position - reach_ * phase.normal, edge_under(phase.facet, phase.normal));
  return on;
}

/// What the rock flies off: the facets that it was on. (The normal of an edge is none of a plane.)
template <class Surface>
LeftPlanes RockRun<Surface>::left_behind(const OnGround& phase) const {
  LeftPlanes left;
  if (phase.on_facet) left.add(phase.normal, phase.facet);
  if (phase.valley && carries(phase.other_facet, *phase.other_normal)) left.add(*phase.other_normal, phase.other_facet);
  return left;
}

/// Where a sphere leaves the model that goes along a leg until `t`, its centre being beside the terrain before its
/// facet ends.
template <class Surface>
auto RockRun<Surface>::rim_ahead(const Parabola& leg, double t) const -> std::optional<Rim> {
  const auto is_beside = [&](double at) {
    const Vec3 centre = leg.at(at);
    return !surface_.elevation(centre.x(), centre.y(), centre.z());
  };
  if (reach_ == 0 || !is_beside(t)) return std::nullopt;
  double inside = 0;
  for (double middle = 0.5 * t; middle > inside && middle < t; middle = 0.5 * (inside + t)) {
    (is_beside(middle) ? t : inside) = middle;
  }
  // Seen from the last place that has ground below it: of what is beside the terrain, the surface cannot tell whether
  // it is in the open or under ground.
  const auto exit = exit_here(leg.at(inside), leg.velocity(inside));
  return exit ? std::optional(Rim{t, *exit}) : std::nullopt;
}

/// How a rock leaves the model that goes on in free flight, if it does at once.
template <class Surface>
std::optional<Exit> RockRun<Surface>::exit_here(const Vec3& position, const Vec3& velocity) const {
  const Exit exit = surface_.exit({position, velocity, laws_.gravity});
  return exit.t <= 1e-9 && !exit.beneath ? std::optional(exit) : std::nullopt;
}

template <class Surface>
auto RockRun<Surface>::leave_over_rim(const Exit& exit) -> Phase {
  arrive(PathState::impact);
  log_.row(PathState::projectile, motion_);
  return end(reason_of(exit));
}

/// The rock has come to the end of its facet.
template <class Surface>
auto RockRun<Surface>::leave_facet(OnGround& phase, const OutlineEdge& edge) -> Phase {
  note_energy();
  if (!edge.beyond) {
    // At the rim the model ends under the rock's centre; whether its skin would still brush the rim is no matter.
    if (const auto exit = exit_here(motion_.position, motion_.velocity)) return leave_over_rim(*exit);
  }
  if (phase.valley) return leave_valley(phase);
  if (edge.beyond) {
    const Vec3 n = outline_of(*edge.beyond).normal;
    if (is_level(n, motion_.velocity) || grazes(n, motion_.velocity)) {
      // The bottom of a valley, reached along it or over a crease too flat to be struck.
      if (n.dot(edge.inward) > 0 && enter_valley(phase, *edge.beyond, n)) return Phase::on_ground;
      go_on_over(phase, *edge.beyond, n);
      return Phase::on_ground;
    }
    if (motion_.velocity.dot(n) < 0) {
      // A lumped mass slides into ground that rises against it; a sphere touches such ground before it gets here,
      // unless it rises by next to nothing.
      remember_strike(phase.normal, phase.facet);
      return strike({0, n, *edge.beyond, Feature::facet});
    }
  }
  if (reach_ > 0 && pressure_on_edge(phase.facet, phase.normal) > 0) {
    phase.on_facet = false;  // too slow to fly off, it turns about the edge
    return Phase::on_ground;
  }
  return take_off(left_behind(phase));
}

/// A facet ahead is level, or only grazed: the rock goes on over it.
template <class Surface>
void RockRun<Surface>::go_on_over(OnGround& phase, FacetId facet, const Vec3& n) {
  if (reach_ > 0) phase.other_normal = phase.normal;
  const bool is_other_ground = material_at(phase.facet) != material_at(facet);
  phase.facet = facet;
  phase.normal = n;
  if (is_other_ground) redraw_friction(phase);
  if (is_level(n, motion_.velocity)) {
    motion_.velocity = tangential(motion_.velocity, n);
  } else {
    settle_onto(n, phase.mu);
    log_.row(PathState::sliding, motion_);
  }
}

/// The ground falls away, or ends. The path shows the place: the rock arrives there and leaves in flight.
template <class Surface>
auto RockRun<Surface>::take_off(const LeftPlanes& left) -> Phase {
  arrive(PathState::impact);
  log_.row(PathState::projectile, motion_);
  return fly_off(left);
}

}  // namespace talus
