import { expect, test } from 'vitest';
import { displayedIn } from './units';

const shown = (value: number, unit: string) => {
  const { unit: displayed, per } = displayedIn('US customary', unit);
  return [value / per, displayed] as const;
};

test('energies are in kJ, other units as in the files', () => {
  expect(displayedIn('metric', 'J')).toEqual({ unit: 'kJ', per: 1000 });
  expect(displayedIn('metric', 'J²')).toEqual({ unit: 'kJ²', per: 1e6 });
  expect(displayedIn('metric', 'm/s')).toEqual({ unit: 'm/s', per: 1 });
});

test('feet, pounds and kip-feet', () => {
  expect(shown(0.3048, 'm')).toEqual([1, 'ft']);
  expect(shown(0.45359237, 'kg')).toEqual([1, 'lb']);
  expect(shown(1000, 'kJ')[0]).toBeCloseTo(737.562149, 6); // 1 ft lbf = 1.355 817 948 J
  expect(shown(1e6, 'J')[0]).toBeCloseTo(737.562149, 6);
  expect(shown(0.3048 ** 2, 'm²')).toEqual([1, 'ft²']);
  expect(shown(3, 's')).toEqual([3, 's']);
});

test('shares are in percent', () => expect(displayedIn('US customary', 'share')).toEqual({ unit: '%', per: 0.01 }));
