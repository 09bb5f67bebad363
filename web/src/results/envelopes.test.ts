import { expect, test } from 'vitest';
import { curvesOf, envelopeRows } from '../figures/envelope';
import { envelopesOf, quantitiesOf } from './envelopes';

const csv = `x_m,passages,reach_share,energy_total_mean_kJ,energy_total_p99.5_kJ,energy_total_max_kJ,velocity_mean_m_s
0.5,4,1,700,1100,1200,3.5
1.5,0,,,,,
2.5,1,0.25,300,300,300,1
`;
const cells = envelopesOf(csv, 'Run', 'red');

test('cells that no rock passed have no values', () => {
  expect(cells.x).toEqual([0.5, 1.5, 2.5]);
  expect([cells.from, cells.to]).toEqual([[0, 1, 2], [1, 2, 3]]); // prettier-ignore
  expect([...cells.values.keys()]).not.toContain('x_m');
  expect(cells.values.get('passages')).toEqual([4, 0, 1]);
  expect(cells.values.get('energy_total_max_kJ')).toEqual([1200, null, 300]);
});

test('quantities have the curves of the file, the maximum first', () => {
  const columns = [...cells.values.keys()];
  expect(quantitiesOf(cells).map(({ key }) => [key, curvesOf(columns, key).map(({ title }) => title)])).toEqual([
    ['energy_total', ['maximum', 'percentile 99.5', 'mean']],
    ['velocity', ['mean']],
    ['reach_share', ['']],
    ['passages', ['']],
  ]);
});

test('the range between ensembles follows the curves of all rocks', () => {
  const columns = ['reach_share', 'reach_share_low', 'reach_share_high', 'reach_share_parameter_part'];
  expect(curvesOf(columns, 'reach_share').map(({ title, style }) => [title, style])).toEqual([
    ['all rocks', 'maximum'],
    ['5 % of ensembles below', 'band'],
    ['5 % of ensembles above', 'band'],
  ]);
  const energies = ['energy_total_max_kJ', 'energy_total_p95_kJ', 'energy_total_p95_low_kJ', 'energy_total_max_high_kJ'];
  expect(curvesOf(energies, 'energy_total').map(({ column, title }) => [column, title])).toEqual([
    ['energy_total_max_kJ', 'maximum'],
    ['energy_total_p95_kJ', 'percentile 95'],
    ['energy_total_max_high_kJ', 'maximum, 5 % of ensembles above'],
  ]);
});

test('the saved table has the numbers of the file', () => {
  expect(envelopeRows([cells], 'velocity')).toEqual([
    ['x_m', 'from_x_m', 'to_x_m', 'velocity_mean_m_s'],
    [0.5, 0, 1, 3.5],
    [1.5, 1, 2, ''],
    [2.5, 2, 3, 1],
  ]);
});

test('a file without rocks has no cells', () => {
  expect(envelopesOf('x_m,passages\n', 'Run', 'red').x).toEqual([]);
});
