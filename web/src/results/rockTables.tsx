import type { RockAnswer, Run } from '../api/types';
import { hitColumns, pathColumns } from '../generated/columns';
import { numberText } from '../units/numbers';
import { DataTable, type Column } from '../charts/DataTable';
import { displayOfColumn, type HitColumn, type PathColumn } from '../charts/columns';
import { DigitsSwitch } from '../charts/DigitsSwitch';
import { fileName } from '../charts/save';

/// The headings of the verification manual's path tables.
const pathTitles: Record<Exclude<PathColumn, 'rock'>, string> = {
  event: 'Id',
  state: 'State',
  time_s: 'Time',
  x_m: 'x',
  y_m: 'y',
  z_m: 'z',
  vx_m_s: 'Velocity x',
  vy_m_s: 'Velocity y',
  vz_m_s: 'Velocity z',
  wx_rad_s: 'Spin x',
  wy_rad_s: 'Spin y',
  wz_rad_s: 'Spin z',
  ke_translational_J: 'Kinetic, translational',
  ke_rotational_J: 'Kinetic, rotational',
  pe_J: 'Potential',
  qw: 'Orientation w',
  qx: 'Orientation x',
  qy: 'Orientation y',
  qz: 'Orientation z',
};
const hitTitles: Record<Exclude<HitColumn, 'rock' | 'ensemble' | PathColumn>, string> = {
  barrier: 'Barrier',
  impact_height_m: 'Contact height',
  angle_deg: 'Angle',
  ke_total_J: 'Kinetic, total',
  outcome: 'Outcome',
  top_height_m: 'Top height',
};
const tableTitles: Readonly<Record<string, string>> = { ...pathTitles, ...hitTitles };

const columnOf = (key: string, declared: Readonly<Record<string, { kind: string; unit: string }>>): Column => ({
  key,
  title: tableTitles[key] ?? key,
  unit: declared[key]?.unit ?? '',
  isText: declared[key]?.kind === 'word',
});

interface Props {
  run: Run;
  rock: number;
  path: RockAnswer;
}

export function PathTable({ run, rock, path }: Props) {
  // The rock is the same in all rows; spheres and points have no orientation.
  const kept = path.columns.flatMap((key, k) => (key === 'rock' || path.rows.every((row) => row[k] === '') ? [] : [k]));
  return (
    <DataTable
      caption={`Trajectory of rock ${rock}`}
      file={fileName(run.name, `rock ${rock} path`)}
      isSeries
      tools={<DigitsSwitch />}
      columns={kept.map((k) => columnOf(path.columns[k]!, pathColumns))}
      rows={path.rows.map((row) => kept.map((k) => row[k]!))}
      rowClass={(k) => `state-${path.rows[k]![path.columns.indexOf('state')]}`}
    />
  );
}

export function HitsTable({ run, rock, path }: Props) {
  const first = path.hits[0];
  if (!first) return null;
  const keys = Object.keys(first).filter((key) => key !== 'rock' && key !== 'ensemble');
  return (
    <DataTable
      caption="Barriers hit"
      file={fileName(run.name, `rock ${rock} hits`)}
      isSeries
      columns={keys.map((key) => columnOf(key, hitColumns))}
      rows={path.hits.map((hit) => keys.map((key) => hit[key] ?? ''))}
    />
  );
}

/// Of a block. A section has no third axis.
function blockFacts(endpoint: Record<string, string>): [string, string][] {
  const { unit, per } = displayOfColumn('a_m');
  const axes = [endpoint.a_m, endpoint.b_m, endpoint.c_m].filter((axis) => axis !== '' && axis !== undefined);
  const facts: [string, string][] = [['Axes', `${axes.map((axis) => numberText(Number(axis) / per)).join(' × ')} ${unit}`]];
  if (endpoint.short_axis_share) facts.push(['Spin about the shortest axis', `${numberText(100 * Number(endpoint.short_axis_share))} %`]);
  return facts;
}

/// The main values of the rock's row of endpoints.csv.
export function RockFacts({ endpoint }: { endpoint: Record<string, string> }) {
  const number = (key: string) => {
    const { unit, per } = displayOfColumn(key);
    return `${numberText(Number(endpoint[key]) / per)} ${unit}`;
  };
  const facts: [string, string][] = [
    ['Seeder', endpoint.seeder ?? ''],
    ...(endpoint.ensemble ? [['Ensemble', endpoint.ensemble] as [string, string]] : []),
    ['Mass', number('mass_kg')],
    ...(endpoint.a_m ? blockFacts(endpoint) : []),
    ['End reason', endpoint.end_reason ?? ''],
    ['Runout on plan', number('runout_xy_m')],
    ['Time', number('time_s')],
    ['Maximum total kinetic energy', number('max_ke_J')],
    ['Maximum bounce height (lowest point)', number('max_bounce_m')],
  ];
  return (
    <dl class="rock-facts">
      {facts.map(([words, value]) => (
        <div key={words}>
          <dt>{words}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
