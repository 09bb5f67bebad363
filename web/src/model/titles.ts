// What settings and their units are called on the page.

// Where the key alone would read badly; of one table, or of all.
const titles: Record<string, string> = {
  'design.lines': 'Candidate lines',
  'seeder.lines': 'Lines of a file',
  'seeder.points': 'Points of a line',
  'seeder.polygon': 'Polygon',
  'seeder.polygons': 'Polygons of a file',
  'terrain.boundary': 'Boundary of the survey',
  'terrain.lines': 'Contours and breaklines',
  'terrain.points': 'Surveyed points',
  crs: 'Coordinate system',
  geopackage: 'Rocks in the GeoPackage',
  like: 'Values of the library',
  max_edge_m: 'Longest edge',
  max_slope_deg: 'Steepest slope',
  max_steps: 'Most steps',
  max_time_s: 'Longest time',
  max_timestep_s: 'Time step',
  min_slope_deg: 'Gentlest slope',
  model: 'Rock model',
  paths: 'Rocks with paths',
  place: 'Place in the cell',
  raster_cell_m: 'Cell of the maps',
  rel_max: 'Relative maximum',
  rel_min: 'Relative minimum',
  rn_mass_scale_kg: 'Mass scale of Rn',
  rn_velocity_scale_m_s: 'Velocity scale of Rn',
  scale_rn_by_mass: 'Scale Rn by mass',
  scale_rn_by_velocity: 'Scale Rn by velocity',
  section_std_dev_m: 'Standard deviations of the vertices',
  std_dev: 'Standard deviation',
  tangential_crsp_damping: 'Tangential CRSP damping',
  vtk: 'Paths for ParaView',
};

/// "Normal restitution" of normal_restitution, "Forest height" of forest_height_m: the key without its unit.
export function titleOf(key: string, unit = '', table = ''): string {
  const given = titles[`${table}.${key}`] ?? titles[key];
  if (given) return given;
  const ending = `_${unit.replace('1/', 'per_').replaceAll('/', '_')}`;
  const bare = unit && key.endsWith(ending) ? key.slice(0, -ending.length) : key;
  return `${bare.charAt(0).toUpperCase()}${bare.slice(1).replaceAll('_', ' ')}`;
}

/// "m/s²" of m/s2, "°" of deg.
export function unitText(unit: string): string {
  return unit
    .replace('deg', '°')
    .replace(/([a-z])2\b/, '$1²')
    .replace(/([a-z])3\b/, '$1³');
}
