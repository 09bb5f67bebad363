import { expect, test } from 'vitest';
import { classOf, classText, type MapClass } from './classes';

const limits = [0, 30, 100, 300, 1000, 3000, null];
const energies: MapClass[] = limits.slice(0, -1).map((from, k) => ({ from: from!, to: limits[k + 1]!, colour: [k, 0, 0] }));

test('a class includes its lower limit and excludes its upper one', () => {
  expect([0, 29.99, 30, 99.9, 100, 2999, 3000, 1e9].map((value) => classOf(energies, value))).toEqual([0, 0, 1, 1, 2, 4, 5, 5]);
});
test('a legend shows all limits', () => {
  expect(energies.map((each, k) => classText(each, k === 0))).toEqual(['< 30', '30 – 100', '100 – 300', '300 – 1,000', '1,000 – 3,000', '≥ 3,000']);
  expect(classText({ from: 1e-5, to: 0.001, colour: [0, 0, 0] }, false)).toBe('1e−5 – 0.001');
});
