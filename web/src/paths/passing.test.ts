import { expect, test } from 'vitest';
import { everyRock } from '../runs/filter';
import { passing } from './passing';

const rocks = {
  header: { reasons: ['rest', 'left'], seeders: ['Crest', 'Ledge'], sources: ['a'], barriers: ['Net', 'Wall'] },
  rocks: Uint32Array.of(3, 5, 8),
  reasons: Uint8Array.of(0, 1, 1),
  releases: Uint32Array.of(0, 7, 7),
  seeders: Uint16Array.of(0, 0, 1),
  sources: Uint16Array.of(0, 0, 0),
  maxEnergies: Float32Array.of(10, 20, 30),
  barriers: Uint32Array.of(0, 1, 2),
};
const passes = (some: Partial<typeof everyRock>) => [...passing(rocks, { ...everyRock, ...some })];

test('without conditions all rocks pass', () => expect(passes({})).toEqual([1, 1, 1]));
test('names of one condition are alternatives', () => {
  expect(passes({ reasons: ['left'] })).toEqual([0, 1, 1]);
  expect(passes({ reasons: ['left', 'rest'] })).toEqual([1, 1, 1]);
  expect(passes({ reasons: [] })).toEqual([0, 0, 0]);
});
test('all conditions must be met', () => expect(passes({ reasons: ['left'], seeders: ['Crest'] })).toEqual([0, 1, 0]));
test('the barrier condition is on hits', () => {
  expect(passes({ barriers: ['Wall'] })).toEqual([0, 0, 1]);
  expect(passes({ barriers: ['Net', 'Wall'] })).toEqual([0, 1, 1]);
});
test('rocks of a release place', () => {
  expect(passes({ releases: [7] })).toEqual([0, 1, 1]);
  expect(passes({ releases: [0, 7], seeders: ['Crest'] })).toEqual([1, 1, 0]);
});
test('rocks that cross a line, once they are known', () => {
  const crossing = (known: ReadonlySet<number> | null) => [...passing(rocks, { ...everyRock, crossing: 's1' }, known)];
  expect(crossing(new Set([3, 8]))).toEqual([1, 0, 1]);
  expect(crossing(null)).toEqual([1, 1, 1]);
});
test('the limits of the energy pass', () => expect(passes({ minEnergy_kJ: 10, maxEnergy_kJ: 20 })).toEqual([1, 1, 0]));
test('more than 32 barriers are supported', () => {
  const names = Array.from({ length: 70 }, (_, k) => `Net ${k + 1}`);
  const barriers = new Uint32Array(9);
  barriers[2] = 1 << 5; // the first rock hits number 70
  barriers[3] = 1 << 31; // the second number 32
  const crowd = { ...rocks, header: { ...rocks.header, barriers: names }, barriers };
  const hits = (...chosen: string[]) => [...passing(crowd, { ...everyRock, barriers: chosen })];
  expect(hits('Net 70')).toEqual([1, 0, 0]);
  expect(hits('Net 32', 'Net 6')).toEqual([0, 1, 0]);
});
