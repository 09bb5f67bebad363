#pragma once
// The thresholds of the kernel - contact, motion along the ground, barriers - each with its unit, its reason, and what
// goes wrong if it is changed. They are smaller than anything measurable on a slope, and larger than the rounding of
// coordinates in the local frame (1e-11 m at 100 km). None of them is a property of ground or rock: those are settings.

namespace talus::tolerance {

// ---- contact ----

/// Thickness [m] within which a rock counts as on a surface. Contacts are found as if every facet were this thick, so
/// that no rock passes between two facets by rounding. Smaller: rocks are lost through edges. Larger: a rock that
/// leaves slowly counts as on the ground.
inline constexpr double contact_slack = 1e-9;

/// Margin of bounding boxes, and the height above a facet at which a flight certainly misses it [m]. Smaller than the
/// outlines' slack (terrain/facet_contact.hpp): contacts at edges are lost. Larger: only slower.
inline constexpr double box_pad = 1e-6;

/// The flattest approach, as a ratio of tangential to normal speed, for which the slack of an outline grows. A flatter
/// approach is rounding.
inline constexpr double flattest_approach = 1e4;
/// An upper bound of the distance of a contact from the outline of its facet [m].
inline constexpr double widest_slack = 2 * flattest_approach * contact_slack;

/// A component of a speed below this share of it is rounding.
inline constexpr double share_by_rounding = 1e-9;

/// For a place nearer to a facet than this, the facet's normal is used as the direction away from it [m].
inline constexpr double no_distance = 1e-6;

/// A path that leaves the model further below a facet than this fell through it [m].
inline constexpr double fell_through = 1e-6;

/// Shorter times over a facet are rounding at its border with the next [s].
inline constexpr double no_time = 1e-9;

/// A sphere can touch an edge or a vertex before a facet if the facets there fall away by more than this share of their
/// length.
inline constexpr double sharp_bend = 1e-9;

/// Two facets are in one plane if the cosine between their normals is greater than 1 minus this (1.4e-6 rad apart):
/// more than rounding, but far too little to affect a rock. Smaller: elevations rounded to float make creases in
/// planes, and every crease an impact. Larger: real bends are slid over.
inline constexpr double same_plane = 1e-12;

/// Sine of the bend up to which a rock on the ground moves on over the next facet as over its own: slightly more than
/// the angle of `same_plane`, so that there is no gap between the two.
inline constexpr double level_bend = 2e-6;

/// A support is the facet itself, not one of its edges or vertices, if the cosine between their normals is greater than
/// 1 minus this (4.5e-5 rad). Smaller: a sphere on a facet turns about its edges. Larger: an edge between nearly
/// coplanar facets carries like a plane.
inline constexpr double facet_normal = 1e-9;

/// A rock this near to a plane touches it; and a rock that has left a plane must sink by this before it can meet
/// another facet of it [m]. Smaller than rounding on steep facets (1e-9): a rock strikes the plane that it leaves.
/// Larger: it strikes late where the plane continues.
inline constexpr double touching_plane = 1e-7;

/// A contact this near to the point that carries a sphere is that point [m]: more than the slack of any outline, less
/// than the distance of any other contact.
inline constexpr double at_pivot = 1e-4;

// ---- motion along the ground ----

/// Added to the coefficient of friction: with rounding, a rock without pull would otherwise never rest.
inline constexpr double friction_by_rounding = 1e-12;

/// A rock stays on a straight line if no more than this share of the pull is across its heading.
inline constexpr double straight_pull = 1e-9;

/// On cosines and on shares of gravity, for a rock on several facets: supports that differ by less are one.
inline constexpr double same_support = 1e-9;

/// Distance within which a facet counts as touching a rock that may rest [m].
inline constexpr double support_reach = 1e-6;

/// Slip slower than this is rounding [m/s]; and so is a velocity, whose heading is then meaningless.
inline constexpr double no_slip = 1e-9;
inline constexpr double standstill = 1e-9;
/// Slip slower than this is shown as rolling [m/s].
inline constexpr double shown_as_rolling = 1e-6;

/// If the velocity's difference from the terminal one makes less displacement than this in a step with drag, the step
/// need not be shortened [m].
inline constexpr double unseen_way = 1e-4;

/// Two contacts this near to each other are one contact with both facets [m]. Smaller: a rock between two facets
/// strikes one after the other, up to the limit of steps. Larger: a hop of a pebble becomes a slide in a valley.
inline constexpr double one_contact = 1e-5;

/// A point this near to the line of an edge is on it, for an edge under a sphere [m].
inline constexpr double on_edge_line = 1e-7;

/// An edge or a vertex still touches a sphere in a valley if the cosine between normals is greater than 1 minus this,
/// and the distance less than this above the radius [m].
inline constexpr double still_touching = 1e-6;

/// How far ahead to search for the facets on which a valley continues, or beyond the edges of very many facets [m].
/// Smaller than the outlines' slack: the facet behind is found. Larger: narrow facets are skipped.
inline constexpr double look_ahead = 1e-6;

/// Sine of the angle below which a facet's side runs along a valley, and is not crossed.
inline constexpr double along_valley = 1e-9;

/// How far a sphere moves from a facet that it has left before it can strike that facet again [m]. Smaller: it strikes
/// what it has just rolled off. Larger: it may sink in by this times the angle of the bend.
inline constexpr double past_the_end = 1e-3;

/// The angle by which a sphere turns about an edge in one step [rad]. The path differs from the circle by second order
/// in it.
inline constexpr double edge_step = 0.01;

/// The distance, in radii, that a sphere on a facet moves at most in one step. In a longer one its slip would keep the
/// direction that it has where the step would end, far beyond what the sphere meets on the way.
inline constexpr double longest_step_in_radii = 100;

/// Faces of rough ground are tilted by at most this [rad], just under a quarter turn: they must not face downwards.
inline constexpr double max_tilt = 0.95 * 1.5707963267948966;

/// A rock that has not moved further than this is in the same place [m].
inline constexpr double same_place = 1e-3;
/// And it has the same spin, if the speed of its surface by spin has not changed by more than this [m/s].
inline constexpr double same_spin = 0.1;
/// Contacts in one place after which a rock is stuck. After forty, a bouncing rock has moved on (with a restitution of
/// 0.9 a hundredth of its speed remains); and the default limit of steps is 250 times as many.
inline constexpr double contacts_to_stuck = 40;
/// Contacts in one place after which a rock below the stopping velocity is wedged, and rests.
inline constexpr double contacts_to_rest = 200;

// ---- rocks with a shape ----

/// Corners that come to the ground within this of each other strike it together, and so near to it they are held [m].
/// Smaller: a body that turns about a corner hops, and each hop takes energy.
inline constexpr double one_touch = 1e-4;
/// How near the ground [m], or the time [s], a corner is followed to its contact.
inline constexpr double corner_gap = 1e-8;
inline constexpr double corner_time = 1e-12;
/// The turn of a body between two looks at its corners in a flight [rad]: they leave the chord by an eighth of its
/// square times the reach, 1.2 mm for a metre.
inline constexpr double turn_in_a_step = 0.1;
/// Impacts nearer in time are one chatter [s], which ends on the ground.
inline constexpr double quick_impact = 4e-3;
/// The turn [rad] and the way [m] of a body in one step on the ground.
inline constexpr double turn_in_touch = 0.02;
inline constexpr double way_in_touch = 0.1;
/// A corner strikes at once if it would within this share of a step.
inline constexpr double soon_struck = 1e-3;
/// A body is in the air again if nothing has pushed it for so long [s], and its corners are so far above the ground
/// [m].
inline constexpr double apart_in_flight = 0.01;
inline constexpr double clear_in_flight = 1e-5;
/// It rests if it has hardly moved for so long [s], and the corners this near to the ground [m] hold it: gravity moves
/// it by less than this share.
inline constexpr double quiet_at_rest = 0.3;
inline constexpr double near_touch = 1e-3;
inline constexpr double held_share = 1e-3;
/// It also rests if a step with gravity has left it no more than this share of the step's fall.
inline constexpr double still_share = 1e-5;

/// Sine of the angle between the slip of a contact and the friction against it, below which they are opposite.
inline constexpr double slip_direction = 1e-12;
/// Impulses of several contacts have settled if a round changes the velocities of contacts by less than this share of
/// what all impulses change, in an impact and in a step on the ground, or after so many rounds. Larger: contacts sink in
/// or part by this share of the impact's velocity, or of the step's fall.
inline constexpr double settled_impact = 1e-9;
inline constexpr double settled_step = 1e-6;
inline constexpr int max_sweeps = 64;
/// Rounds before impulses change by half steps: twice as slow, but contacts that drive each other settle.
inline constexpr int sweeps_in_full = 16;
/// Energy that impulses add, below this share of what they turn over, is rounding or has not settled.
inline constexpr double energy_by_rounding = 1e-9;

// ---- the end of a rock ----

/// The edge of the model counts as reached if free flight reaches it within this time [s].
inline constexpr double at_once = 1e-9;

/// Replaces a speed of zero in divisions [m/s].
inline constexpr double least_speed = 1e-300;

// ---- forests ----

/// How far below the exact path a piece of a flight with drag may run [m].
inline constexpr double drag_piece = 1e-3;

/// A flight is checked for forest at least once in this distance [m]: shorter stretches may be missed.
inline constexpr double forest_step = 0.5;
/// Accuracy of a forest's border on the path [m].
inline constexpr double forest_border = 1e-3;

// ---- barriers ----

/// Margin of the ranges in which a barrier may be met [m].
inline constexpr double barrier_range = 1e-6;
/// A place this far beyond an end of a panel still belongs to it [m].
inline constexpr double panel_border = 1e-9;
/// Crossings this close in time are one, so that a part of a path does not begin with the crossing that ended the last
/// one [s].
inline constexpr double same_crossing = 1e-8;

/// An acceleration against a barrier below this is rounding [m/s2], and so is a speed [m/s].
inline constexpr double no_pressing = 1e-9;
/// Minimum speed when the passage of a rock through a barrier is timed [m/s].
inline constexpr double least_passing_speed = 1e-3;

}  // namespace talus::tolerance

namespace talus {

using tolerance::box_pad;
using tolerance::contact_slack;
using tolerance::same_plane;

}  // namespace talus
