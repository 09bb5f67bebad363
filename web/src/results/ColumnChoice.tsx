import { type EndpointNumber, type HitNumber, displayOfColumn, titleOf, withUnit } from '../charts/columns';

/// The choice of a column of a table.
export function ColumnChoice({
  columns,
  now,
  choose,
}: {
  columns: readonly string[];
  now: string;
  choose: (column: string) => void;
}) {
  return (
    <label class="choice">
      Quantity
      <select value={now} onChange={(event) => choose(event.currentTarget.value)}>
        {columns.map((column) => (
          <option key={column} value={column}>
            {withUnit(titleOf(column), displayOfColumn(column).unit)}
          </option>
        ))}
      </select>
    </label>
  );
}

export const endpointChoices: readonly EndpointNumber[] = [
  'runout_xy_m',
  'runout_z_m',
  'runout_total_m',
  'lateral_m',
  'max_ke_J',
  'max_bounce_m',
  'time_s',
  'events',
  'mass_kg',
  'radius_m',
  'x_m',
  'y_m',
  'z_m',
];

/// Columns of the hits on a barrier.
export const hitChoices: readonly HitNumber[] = [
  'ke_total_J',
  'ke_translational_J',
  'ke_rotational_J',
  'impact_height_m',
  'velocity_m_s',
  'angle_deg',
  'station_m',
  'time_s',
];
