import { expect, test } from 'vitest';
import { edited } from './edit';
import { valuesOf } from './values';

test('integers keep all digits when read', () => {
  expect(valuesOf('seed = 9007199254740993')).toEqual({ seed: 9007199254740993n });
  expect(valuesOf('seed = -9007199254740991\nrocks = 50')).toEqual({ seed: -9007199254740991, rocks: 50 });
  expect(valuesOf('rows = [[0x20000000000001, 1]]')).toEqual({ rows: [[9007199254740993n, 1]] });
});

test('integers keep all digits when written', () =>
  expect(edited('seed = 1\n', [{ set: ['seed'], value: 9007199254740993n }])).toBe('seed = 9007199254740993\n'));
