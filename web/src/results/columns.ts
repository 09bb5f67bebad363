// Columns of the result files: what they are called on the page, and in which unit they are read.

const unitsByEnding: readonly (readonly [string, string])[] = [
  ['_rad_s', 'rad/s'],
  ['_m_s', 'm/s'],
  ['_kJ', 'kJ'],
  ['_kg', 'kg'],
  ['_deg', '°'],
  ['_J', 'J'],
  ['_m', 'm'],
  ['_s', 's'],
];

const titles: Record<string, string> = {
  rock: 'Rock',
  seeder: 'Seeder',
  x_m: 'End point, x',
  y_m: 'End point, y',
  z_m: 'End point, z',
  end_x_m: 'End point, x',
  runout_xy_m: 'Runout on plan',
  runout_z_m: 'Drop from start to end',
  runout_total_m: 'Runout in space',
  time_s: 'Time',
  events: 'Events',
  end_reason: 'End',
  mass_kg: 'Mass',
  radius_m: 'Radius',
  max_ke_J: 'Greatest total kinetic energy',
  max_bounce_m: 'Greatest bounce height',
  ke_total_J: 'Total kinetic energy',
  ke_translational_J: 'Translational kinetic energy',
  ke_rotational_J: 'Rotational kinetic energy',
  impact_height_m: 'Height above the foot',
  velocity_m_s: 'Velocity',
  angle_deg: 'Angle to the normal',
  station_m: 'Place along the line',
  height_m: 'Height',
};

/// The column of endpoints.csv over which a statistic of summary.json was taken.
const endpointColumnsOfSummary: Record<string, string> = { end_x_m: 'x_m' };
export const endpointColumnOf = (key: string): string => endpointColumnsOfSummary[key] ?? key;

/// "max_ke_J" is in "J"; nothing for numbers without a unit.
export function unitOf(column: string): string {
  return unitsByEnding.find(([ending]) => column.endsWith(ending))?.[1] ?? '';
}

/// "Greatest kinetic energy"; of a column that is not known, its name in words.
export function titleOf(column: string): string {
  const known = titles[column];
  if (known) return known;
  const ending = unitsByEnding.find(([end]) => column.endsWith(end))?.[0] ?? '';
  const words = column.slice(0, column.length - ending.length).replaceAll('_', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/// Energies are read in kJ: the unit on the page, and by what a file's numbers are divided for it, a power of ten.
export function readingOf(unit: string): { unit: string; per: number; places: number } {
  const places = { J: 3, 'J²': 6 }[unit] ?? 0;
  return places === 0 ? { unit, per: 1, places } : { unit: `k${unit}`, per: 10 ** places, places };
}
/// What is said where numbers are saved that are read in another unit.
export const asInFiles = 'With the numbers of the files: energies in J';
export const savingOf = (column: string) => (readingOf(unitOf(column)).places === 0 ? undefined : asInFiles);

export const withUnit = (title: string, unit: string) => (unit ? `${title} [${unit}]` : title);
