#pragma once
// The thresholds of the kernel - contact, motion along the ground, barriers - each with its unit, its reason, and what
// goes wrong when it is changed. They are lengths and angles below what anybody could measure on a slope, and above
// what rounding makes of coordinates in the local frame (1e-11 m at 100 km). None of them is a property of ground or
// rock: those are settings.

namespace talus::tolerance {

// ---- contact ----

/// Thickness [m] within which a rock counts as being on a surface. Contacts are found as if every facet were this
/// thick, so that no rock passes between two facets for want of digits. Smaller: rocks are lost through edges. Larger:
/// a rock that leaves slowly counts as being on the ground.
inline constexpr double contact_slack = 1e-9;

/// By how much boxes are widened, and how far above a facet a flight must stay to miss it for certain [m]. Smaller than
/// the outlines' slack (terrain/facet_contact.hpp): contacts at edges are lost. Larger: only slower.
inline constexpr double box_pad = 1e-6;

/// Under how flat an approach, as a ratio of tangential to normal speed, a contact beside an outline still belongs to
/// the facet: a rock cannot fall on a facet more flatly; only rounding can.
inline constexpr double flattest_approach = 1e4;
/// More than a contact may ever lie outside the outline of its facet [m].
inline constexpr double widest_slack = 2 * flattest_approach * contact_slack;

/// Of a speed, so little along a direction is rounding.
inline constexpr double share_by_rounding = 1e-9;

/// Nearer to a facet than this, a place has the facet's own normal as the direction from it [m].
inline constexpr double no_distance = 1e-6;

/// A path that is lower than this under a facet where it leaves the model fell through it [m].
inline constexpr double fell_through = 1e-6;

/// Shorter times over a facet are rounding, between it and the next [s].
inline constexpr double no_time = 1e-9;

/// An edge or a vertex is one that a sphere can touch if what meets there falls away by more than this share of its
/// length.
inline constexpr double sharp_bend = 1e-9;

/// Two facets whose normals have a greater cosine than 1 minus this are one plane (1.4e-6 rad apart): so far from each
/// other that rounding cannot confuse it, so near that no rock could tell. Smaller: heights rounded to float make
/// creases in planes, and every crease an impact. Larger: real bends are slid over.
inline constexpr double same_plane = 1e-12;

/// Sine of the angle up to which a rock on the ground goes on over the next facet as if it were its own: a little above
/// the angle of `same_plane`, so that nothing lies between the two.
inline constexpr double level_bend = 2e-6;

/// A normal whose cosine with a facet's is greater than 1 minus this (4.5e-5 rad) is that of the facet itself, and not
/// of one of its edges or vertices. Smaller: a sphere on a facet turns about its edges. Larger: an edge between nearly
/// coplanar facets carries like a plane.
inline constexpr double facet_normal = 1e-9;

/// So near a plane a rock is in it; and the trace by which it must sink before it can meet another facet of a plane
/// that it has left [m]. Smaller than rounding on steep facets (1e-9): a rock strikes the plane it leaves. Larger: it
/// strikes late where the plane goes on.
inline constexpr double touching_plane = 1e-7;

/// So near the point that carries a sphere, what it touches is that point [m]: wider than a facet's outline ever is for
/// a contact, narrower than anything that could be ahead.
inline constexpr double at_pivot = 1e-4;

// ---- motion along the ground ----

/// Of friction's coefficient: by rounding alone a rock would never rest where nothing pulls.
inline constexpr double friction_by_rounding = 1e-12;

/// A pull with no more than this share across the heading keeps a rock on a straight line.
inline constexpr double straight_pull = 1e-9;

/// On cosines and on shares of gravity, where several facets carry a rock: supports that differ by less are one.
inline constexpr double same_support = 1e-9;

/// Reach within which a facet counts as touching a rock that may rest [m].
inline constexpr double support_reach = 1e-6;

/// Slip slower than this is rounding [m/s]; and so is a velocity: it has no heading that could be trusted, which may
/// lead out of the ground or into it.
inline constexpr double no_slip = 1e-9;
inline constexpr double standstill = 1e-9;
/// Slip slower than this is shown as rolling [m/s].
inline constexpr double shown_as_rolling = 1e-6;

/// Where drag leaves a velocity that would be off by less way than this in a step, the step may be a whole one [m].
inline constexpr double unseen_way = 1e-4;

/// Contacts so near each other are one contact with both facets [m]. Smaller: a rock between two facets strikes one
/// after the other, to the limit of steps. Larger: a hop of a pebble becomes a slide in a valley.
inline constexpr double one_contact = 1e-5;

/// So near a line, a point is on it: an edge under a sphere [m].
inline constexpr double on_edge_line = 1e-7;

/// Cosines less than this below 1, and distances [m] less than this above a radius, say that an edge or a vertex still
/// touches a sphere in a valley.
inline constexpr double still_touching = 1e-6;

/// How far ahead to look for the facets on which a valley goes on, or beyond the edges of very many facets [m]. Smaller
/// than the outlines' slack: the facet behind is found. Larger: narrow facets are skipped.
inline constexpr double look_ahead = 1e-6;

/// Sine of the angle within which a facet's side runs along a valley, and is not crossed.
inline constexpr double along_valley = 1e-9;

/// How far a sphere goes from a facet that it has left before that can be struck again [m]: of the length of a facet's
/// end that still touches it. Smaller: it strikes what it has just rolled off. Larger: it may sink in by as much times
/// the angle of the bend.
inline constexpr double past_the_end = 1e-3;

/// By how much a sphere turns about an edge in one step [rad]. The way differs from the circle by second order in it.
inline constexpr double edge_step = 0.01;

/// A rock that has not gone further than this since is where it was [m].
inline constexpr double same_place = 1e-3;
/// And it spins as it did, if the speed of its surface by spin has not changed by more than this [m/s].
inline constexpr double same_spin = 0.1;
/// Contacts in one place after which a rock gets nowhere: forty, by which a bouncing rock has moved on (a restitution
/// of 0.9 leaves a hundredth of its speed), and which fit 250 times into the usual limit of steps.
inline constexpr double contacts_to_nowhere = 40;
/// Contacts in one place after which a rock that is slower than where rocks stop is wedged, and rests.
inline constexpr double contacts_to_rest = 200;

/// The model's end counts as reached if free flight comes to it within this time [s].
inline constexpr double at_once = 1e-9;

/// Where drag or slowness would make a division by zero, this stands for it [m/s].
inline constexpr double least_speed = 1e-300;

// ---- forests ----

/// How far below the exact path a piece of a flight with drag may run [m].
inline constexpr double drag_piece = 1e-3;

/// A forest is looked for at least once in so much of a flight [m]: shorter stays may be missed.
inline constexpr double forest_step = 0.5;
/// To which its border is then found [m].
inline constexpr double forest_border = 1e-3;

// ---- barriers ----

/// By which ranges are widened in which a barrier may be met [m].
inline constexpr double barrier_range = 1e-6;
/// By which a place may lie beyond an end of a panel and still belongs to it [m].
inline constexpr double panel_border = 1e-9;
/// Crossings this close in time are one: what one part of a path ends with, the next one does not begin with [s].
inline constexpr double same_crossing = 1e-8;

/// What presses a rock against a barrier by less than this is rounding [m/s2], and so is a speed below it [m/s].
inline constexpr double no_pressing = 1e-9;
/// What comes to a barrier more slowly counts as this fast when its passage is timed [m/s].
inline constexpr double least_passing_speed = 1e-3;

}  // namespace talus::tolerance

namespace talus {

using tolerance::box_pad;
using tolerance::contact_slack;
using tolerance::same_plane;

}  // namespace talus
