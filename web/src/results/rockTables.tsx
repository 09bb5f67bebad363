import type { RockAnswer, Run } from '../api/types';
import { allDigits } from '../state/view';
import { numberText } from '../ui/format';
import { DataTable, type Column } from './DataTable';
import { DigitsSwitch } from './DigitsSwitch';
import { fileName } from './save';

const column = (key: string, title: string, unit = ''): Column => ({ key, title, unit });

/// As the manual heads its path tables.
const pathColumns: Record<string, Column> = {
  event: column('event', 'Id'),
  state: { key: 'state', title: 'State', isText: true },
  time_s: column('time_s', 'Time', 's'),
  x_m: column('x_m', 'x', 'm'),
  y_m: column('y_m', 'y', 'm'),
  z_m: column('z_m', 'z', 'm'),
  vx_m_s: column('vx_m_s', 'Velocity x', 'm/s'),
  vy_m_s: column('vy_m_s', 'Velocity y', 'm/s'),
  vz_m_s: column('vz_m_s', 'Velocity z', 'm/s'),
  wx_rad_s: column('wx_rad_s', 'Spin x', 'rad/s'),
  wy_rad_s: column('wy_rad_s', 'Spin y', 'rad/s'),
  wz_rad_s: column('wz_rad_s', 'Spin z', 'rad/s'),
  ke_translational_J: column('ke_translational_J', 'Kinetic, translational', 'J'),
  ke_rotational_J: column('ke_rotational_J', 'Kinetic, rotational', 'J'),
  ke_J: column('ke_J', 'Kinetic, total', 'J'),
  pe_J: column('pe_J', 'Potential', 'J'),
  total_J: column('total_J', 'Kinetic and potential', 'J'),
};

interface Props {
  run: Run;
  rock: number;
  path: RockAnswer;
}

export function PathTable({ run, rock, path }: Props) {
  // All rows are of one rock.
  const kept = path.columns.flatMap((key, k) => (key === 'rock' ? [] : [k]));
  return (
    <DataTable
      caption={`Path of rock ${rock}`}
      file={fileName(run.name, `rock ${rock} path`)}
      isSeries
      tools={<DigitsSwitch all={allDigits} />}
      columns={kept.map((k) => pathColumns[path.columns[k]!] ?? column(path.columns[k]!, path.columns[k]!))}
      rows={path.rows.map((row) => kept.map((k) => row[k]!))}
      rowClass={(k) => `state-${path.rows[k]![path.columns.indexOf('state')]}`}
    />
  );
}

const hitColumns: Record<string, Column> = {
  ...pathColumns,
  barrier: { key: 'barrier', title: 'Barrier', isText: true },
  impact_height_m: column('impact_height_m', 'Height', 'm'),
  angle_deg: column('angle_deg', 'Angle', '°'),
  ke_total_J: column('ke_total_J', 'Kinetic, total', 'J'),
  outcome: { key: 'outcome', title: 'Outcome', isText: true },
};

export function HitsTable({ run, rock, path }: Props) {
  const first = path.hits[0];
  if (!first) return null;
  const keys = Object.keys(first).filter((key) => key !== 'rock');
  return (
    <DataTable
      caption="Barriers that it hit"
      file={fileName(run.name, `rock ${rock} hits`)}
      isSeries
      columns={keys.map((key) => hitColumns[key] ?? column(key, key))}
      rows={path.hits.map((hit) => keys.map((key) => hit[key] ?? ''))}
    />
  );
}

/// The rock's row of endpoints.csv, in short.
export function RockFacts({ endpoint }: { endpoint: Record<string, string> }) {
  const number = (key: string, unit: string, per = 1) => `${numberText(Number(endpoint[key]) / per)} ${unit}`;
  const facts: [string, string][] = [
    ['Seeder', endpoint.seeder ?? ''],
    ['Mass', number('mass_kg', 'kg')],
    ['End', endpoint.end_reason ?? ''],
    ['Runout on plan', number('runout_xy_m', 'm')],
    ['Time', number('time_s', 's')],
    ['Greatest total kinetic energy', number('max_ke_J', 'kJ', 1000)],
    ['Greatest bounce height', number('max_bounce_m', 'm')],
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
