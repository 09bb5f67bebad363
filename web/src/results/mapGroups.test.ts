import { expect, test } from 'vitest';
import type { RunMap } from '../api/types';
import { mapGroups } from './mapGroups';

const map = (name: string, meaning: string, unit = '', source: string | null = null): RunMap => ({ name, meaning, unit, least: 0, most: 1, source });

test('bounce height and energy come first', () => {
  const maps = [map('reach_share', 'share of all rocks that were in the cell'), map('energy_total_max_kJ', 'total kinetic energy: maximum over all rocks', 'kJ'), map('bounce_height_max_m', 'bounce height of the lowest point: maximum over all rocks', 'm')];
  expect(mapGroups(maps).map(({ title }) => title)).toEqual(['Bounce height of the lowest point', 'Total kinetic energy', 'Counts']);
});

test('maps of one quantity and source are together, counts in one group', () => {
  const maps = [
    map('passages', 'rocks that were in the cell'),
    map('deposits', 'rocks that came to rest in the cell'),
    map('velocity_max_m_s', 'velocity: maximum over all rocks', 'm/s'),
    map('velocity_p95_m_s', 'velocity: percentile 95 of the rocks', 'm/s'),
    map('west/velocity_max_m_s', 'velocity: maximum over all rocks', 'm/s', 'west'),
  ];
  const texts = mapGroups(maps).map(({ title, unit, source, maps: of }) => [title, unit, source, ...of.map(({ map: { name }, part }) => `${name} = ${part}`)]);
  expect(texts).toEqual([
    ['Velocity', 'm/s', null, 'velocity_max_m_s = maximum over all rocks', 'velocity_p95_m_s = percentile 95 of the rocks'],
    ['Velocity', 'm/s', 'west', 'west/velocity_max_m_s = maximum over all rocks'],
    ['Counts', '', null, 'passages = rocks that were in the cell', 'deposits = rocks that came to rest in the cell'],
  ]);
});
