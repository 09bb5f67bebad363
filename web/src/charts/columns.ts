// Titles and displayed units of the columns of result files.

import {
  designQuantities,
  endpointColumns,
  endpointNumbers,
  hitColumns,
  hitNumbers,
  pathColumns,
} from '../generated/columns';
import { displayOf, unitSystem } from '../state/displayUnits';
import type { Displayed } from '../units/units';

/// What statistics can be asked for: of end points, and of the hits on a barrier.
export type EndpointNumber = keyof typeof endpointNumbers;
export type HitNumber = keyof typeof hitNumbers;
export type PathColumn = keyof typeof pathColumns;
export type HitColumn = keyof typeof hitColumns;

const units: ReadonlyMap<string, string> = new Map(
  [endpointColumns, pathColumns, hitColumns, endpointNumbers, hitNumbers, designQuantities].flatMap((table) =>
    Object.entries(table).map(([column, { unit }]) => [column, unit] as const),
  ),
);

const titles: Record<
  EndpointNumber | Exclude<HitNumber, 'vx_m_s' | 'vy_m_s' | 'vz_m_s'> | keyof typeof designQuantities | 'end_x_m',
  string
> = {
  x_m: 'End point, x',
  y_m: 'End point, y',
  z_m: 'End point, z',
  end_x_m: 'End point, x',
  runout_xy_m: 'Runout on plan',
  runout_z_m: 'Drop from release to end',
  runout_total_m: 'Runout in space',
  lateral_m: 'Distance beside the line',
  time_s: 'Time',
  events: 'Events',
  mass_kg: 'Mass',
  radius_m: 'Radius',
  max_ke_J: 'Maximum total kinetic energy',
  max_bounce_m: 'Maximum bounce height (lowest point)',
  a_m: 'Longest axis a',
  b_m: 'Intermediate axis b',
  c_m: 'Shortest axis c',
  short_axis_share: 'Share of spin about the shortest axis',
  ke_total_J: 'Total kinetic energy',
  ke_translational_J: 'Translational kinetic energy',
  ke_rotational_J: 'Rotational kinetic energy',
  impact_height_m: 'Impact height (contact)',
  top_height_m: "Height of the block's top",
  velocity_m_s: 'Velocity',
  angle_deg: 'Angle to the normal',
  station_m: 'Distance along the line',
  height_m: "Height of the block's top",
};

/// The column of endpoints.csv for each statistic of summary.json, if its name differs.
const endpointColumnsOfSummary: Record<string, string> = { end_x_m: 'x_m' };
export const endpointColumnOf = (key: string): string => endpointColumnsOfSummary[key] ?? key;

/// "J" for "max_ke_J"; empty for numbers without a unit.
export const unitOf = (column: string): string => units.get(endpointColumnOf(column)) ?? '';

/// The title of a column, or its name if it has none.
export const titleOf = (column: string): string => titles[column as keyof typeof titles] ?? column;

/// Places are metric always, as on the map and in the forms.
const places: ReadonlySet<string> = new Set(['x_m', 'y_m', 'z_m', 'end_x_m', 'station_m']);

/// How numbers of a column in `unit` are shown.
export const displayOfColumn = (column: string, unit = unitOf(column)): Displayed =>
  places.has(column) ? { unit, per: 1 } : displayOf(unit);

/// A remark on saved numbers that are displayed in another unit.
export const asInFiles = () =>
  unitSystem.value === 'metric' ? 'With the numbers of the files: energies in J' : 'With the numbers of the files, in metric units';
export const savingOf = (column: string) => (displayOfColumn(column).per === 1 ? undefined : asInFiles());

export const withUnit = (title: string, unit: string) => (unit ? `${title} [${unit}]` : title);
