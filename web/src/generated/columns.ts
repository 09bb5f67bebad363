// Made from the declarations of the tables of a run (src/talus/archive/table_columns.hpp) by column_reference.cpp; not
// written by hand. To renew it: TALUS_RENEW_REFERENCE=1 and run the test ColumnsModule.IsNotStale.

export const endpointColumns = {
  rock: {"kind":"key","unit":"","meaning":"number of the rock, from 0, seeder after seeder"},
  seeder: {"kind":"word","unit":"","meaning":"name of its seeder"},
  x_m: {"kind":"quantity","unit":"m","meaning":"x of its centre where it ended"},
  y_m: {"kind":"quantity","unit":"m","meaning":"y of its centre"},
  z_m: {"kind":"quantity","unit":"m","meaning":"z of its centre"},
  runout_xy_m: {"kind":"quantity","unit":"m","meaning":"distance from release to end on plan; with `runout_from` or `runout_along`, from that point or along that line"},
  runout_z_m: {"kind":"quantity","unit":"m","meaning":"z at the release minus z at the end: positive downwards"},
  runout_total_m: {"kind":"quantity","unit":"m","meaning":"straight distance from release to end in space"},
  lateral_m: {"kind":"quantity","unit":"m","meaning":"with `runout_along`: distance from the line on plan, positive to its left; otherwise empty"},
  time_s: {"kind":"quantity","unit":"s","meaning":"time from release to end"},
  events: {"kind":"quantity","unit":"","meaning":"number of impacts, hits on barriers and take-offs where the ground falls away or ends"},
  end_reason: {"kind":"word","unit":"","meaning":"why the trajectory ended"},
  ground: {"kind":"word","unit":"","meaning":"material of the ground straight below its centre where it ended; empty if it left the model"},
  mass_kg: {"kind":"quantity","unit":"kg","meaning":"mass"},
  radius_m: {"kind":"quantity","unit":"m","meaning":"radius of the equivalent sphere"},
  max_ke_J: {"kind":"quantity","unit":"J","meaning":"maximum total kinetic energy: translational and rotational"},
  max_bounce_m: {"kind":"quantity","unit":"m","meaning":"maximum bounce height: of the block's lowest point above the ground straight below it"},
  ensemble: {"kind":"key","unit":"","meaning":"with `sampling.parameters`: number of the rock's ensemble, from 0; otherwise empty"},
  a_m: {"kind":"quantity","unit":"m","meaning":"runs with blocks: length along its longest principal axis; of spheres empty"},
  b_m: {"kind":"quantity","unit":"m","meaning":"along the intermediate one"},
  c_m: {"kind":"quantity","unit":"m","meaning":"along the shortest one; in 2D empty, as the next"},
  short_axis_share: {"kind":"quantity","unit":"","meaning":"of a block: the part of its angular momentum along its shortest axis, mean over the time of its flights: near 1 it rolls as a wheel"},
} as const;

export const pathColumns = {
  rock: {"kind":"key","unit":"","meaning":"number of the rock"},
  event: {"kind":"key","unit":"","meaning":"number of the row of this rock, from 0"},
  state: {"kind":"word","unit":"","meaning":"state of the rock from this row on; `impact` and `barrier`: it arrives"},
  time_s: {"kind":"quantity","unit":"s","meaning":"time since the release"},
  x_m: {"kind":"quantity","unit":"m","meaning":"x of its centre"},
  y_m: {"kind":"quantity","unit":"m","meaning":"y of its centre"},
  z_m: {"kind":"quantity","unit":"m","meaning":"z of its centre"},
  vx_m_s: {"kind":"quantity","unit":"m/s","meaning":"x of its velocity"},
  vy_m_s: {"kind":"quantity","unit":"m/s","meaning":"y of its velocity"},
  vz_m_s: {"kind":"quantity","unit":"m/s","meaning":"z of its velocity"},
  wx_rad_s: {"kind":"quantity","unit":"rad/s","meaning":"x of its spin, about the axes of the coordinates"},
  wy_rad_s: {"kind":"quantity","unit":"rad/s","meaning":"y of its spin: rolling towards +x is positive"},
  wz_rad_s: {"kind":"quantity","unit":"rad/s","meaning":"z of its spin"},
  ke_translational_J: {"kind":"quantity","unit":"J","meaning":"translational kinetic energy"},
  ke_rotational_J: {"kind":"quantity","unit":"J","meaning":"rotational kinetic energy"},
  pe_J: {"kind":"quantity","unit":"J","meaning":"potential energy above the datum"},
  qw: {"kind":"quantity","unit":"","meaning":"runs with blocks: how it is turned, w, 0 or more, of the quaternion from its principal axes, the longest along x, to the axes of the coordinates; of spheres empty"},
  qx: {"kind":"quantity","unit":"","meaning":"x of it"},
  qy: {"kind":"quantity","unit":"","meaning":"y of it"},
  qz: {"kind":"quantity","unit":"","meaning":"z of it"},
} as const;

export const hitColumns = {
  barrier: {"kind":"word","unit":"","meaning":"name of the barrier or collector"},
  rock: {"kind":"key","unit":"","meaning":"number of the rock"},
  time_s: {"kind":"quantity","unit":"s","meaning":"time since the release"},
  x_m: {"kind":"quantity","unit":"m","meaning":"x of its centre"},
  y_m: {"kind":"quantity","unit":"m","meaning":"y of its centre"},
  z_m: {"kind":"quantity","unit":"m","meaning":"z of its centre"},
  impact_height_m: {"kind":"quantity","unit":"m","meaning":"height above the foot, along the face: of the contact point, at a collector of the centre"},
  vx_m_s: {"kind":"quantity","unit":"m/s","meaning":"x of its velocity on arrival"},
  vy_m_s: {"kind":"quantity","unit":"m/s","meaning":"y of its velocity"},
  vz_m_s: {"kind":"quantity","unit":"m/s","meaning":"z of its velocity"},
  angle_deg: {"kind":"quantity","unit":"°","meaning":"angle between the velocity and the face's normal, positive towards the foot"},
  ke_translational_J: {"kind":"quantity","unit":"J","meaning":"translational kinetic energy"},
  ke_rotational_J: {"kind":"quantity","unit":"J","meaning":"rotational kinetic energy"},
  ke_total_J: {"kind":"quantity","unit":"J","meaning":"total kinetic energy"},
  outcome: {"kind":"word","unit":"","meaning":"outcome of the hit"},
  ensemble: {"kind":"key","unit":"","meaning":"with `sampling.parameters`: number of the rock's ensemble, from 0; otherwise empty"},
  top_height_m: {"kind":"quantity","unit":"m","meaning":"height of the block's top above the foot, along the face: what a fence must have to cover it"},
} as const;

// What statistics are made of: the quantities of a table, and what follows from them.

export const endpointNumbers = {
  x_m: {"unit":"m"},
  y_m: {"unit":"m"},
  z_m: {"unit":"m"},
  runout_xy_m: {"unit":"m"},
  runout_z_m: {"unit":"m"},
  runout_total_m: {"unit":"m"},
  lateral_m: {"unit":"m"},
  time_s: {"unit":"s"},
  events: {"unit":""},
  mass_kg: {"unit":"kg"},
  radius_m: {"unit":"m"},
  max_ke_J: {"unit":"J"},
  max_bounce_m: {"unit":"m"},
  a_m: {"unit":"m"},
  b_m: {"unit":"m"},
  c_m: {"unit":"m"},
  short_axis_share: {"unit":""},
} as const;

export const hitNumbers = {
  time_s: {"unit":"s"},
  x_m: {"unit":"m"},
  y_m: {"unit":"m"},
  z_m: {"unit":"m"},
  station_m: {"unit":"m"},
  impact_height_m: {"unit":"m"},
  vx_m_s: {"unit":"m/s"},
  vy_m_s: {"unit":"m/s"},
  vz_m_s: {"unit":"m/s"},
  velocity_m_s: {"unit":"m/s"},
  angle_deg: {"unit":"°"},
  ke_translational_J: {"unit":"J"},
  ke_rotational_J: {"unit":"J"},
  ke_total_J: {"unit":"J"},
  top_height_m: {"unit":"m"},
} as const;

// The quantities of a design, as summary.json names them.

export const designQuantities = {
  ke_translational_J: {"unit":"J"},
  ke_total_J: {"unit":"J"},
  velocity_m_s: {"unit":"m/s"},
  height_m: {"unit":"m"},
} as const;

// What maps and envelopes.csv show, along a section (src/talus/maps/map_subjects.hpp).

export const sectionFigures = {
  energy_total: {"title":"Total kinetic energy","unit":"kJ","per":1.0},
  energy_translational: {"title":"Translational kinetic energy","unit":"kJ","per":1.0},
  velocity: {"title":"Velocity","unit":"m/s","per":1.0},
  bounce_height: {"title":"Bounce height (lowest point)","unit":"m","per":1.0},
  reach_share: {"title":"Reach probability","unit":"%","per":0.01},
  passages: {"title":"Passages","unit":"","per":1.0},
  deposits: {"title":"Deposits","unit":"","per":1.0},
  impacts: {"title":"Impacts","unit":"","per":1.0},
} as const;
