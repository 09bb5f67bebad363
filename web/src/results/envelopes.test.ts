import { expect, test } from 'vitest';
import { envelopesOf, quantitiesOf } from './envelopes';

const csv = `x_m,passages,reach_share,energy_total_max_kJ,energy_total_p99.5_kJ,velocity_mean_m_s
0.5,4,1,1200,1100,3.5
1.5,0,,,,
2.5,1,0.25,300,300,1
`;

test('cells that no rock touched have nothing', () => {
  const { x, columns } = envelopesOf(csv);
  expect(x).toEqual([0.5, 1.5, 2.5]);
  expect([...columns.keys()]).not.toContain('x_m');
  expect(columns.get('passages')).toEqual([4, 0, 1]);
  expect(columns.get('energy_total_max_kJ')).toEqual([1200, null, 300]);
});

test('quantities with the figures that the file has', () => {
  expect(quantitiesOf(envelopesOf(csv)).map(({ key, figures }) => [key, figures.map(({ title }) => title)])).toEqual([
    ['energy_total', ['Maximum', 'Percentile 99.5']],
    ['velocity', ['Mean']],
    ['reach_share', ['Share of rocks that get here']],
    ['passages', ['Rocks that were here']],
  ]);
});

test('of no rocks there is nothing', () => {
  expect(envelopesOf('x_m,passages\n').x).toEqual([]);
});
