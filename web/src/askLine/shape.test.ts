import { expect, test } from 'vitest';
import { askedOf, missingPoints, moved, shapeOf, textOf, type Asked } from './shape';

const line: Asked = { kind: 'line', points: [[1, 2], [3, 4]] };
test('what is asked is kept as text; anything else is nothing', () => {
  for (const one of [line, { kind: 'barrier', name: 'Net "1"' }, { kind: 'polygon', points: [] }] as Asked[])
    expect(askedOf(textOf(one))).toEqual(one);
  expect(textOf(line)).toBe('line~1,2~3,4');
  expect(askedOf('barrier~a~b')).toEqual({ kind: 'barrier', name: 'a~b' });
  for (const text of ['', 'line~1', 'line~1,2~3,', 'line~1,2,3', 'polygon~a,b', 'barrier', '7'])
    expect(askedOf(text)).toBeNull();
});
test('as in a request', () => {
  expect(shapeOf(line)).toEqual({ line: [[1, 2], [3, 4]] });
  expect(shapeOf({ kind: 'barrier', name: 'Net' })).toEqual({ barrier: 'Net' });
});
test('points that are missing', () => {
  expect(missingPoints({ kind: 'line', points: [[1, 2]] }, 3)).toBe(1);
  expect(missingPoints({ kind: 'line', points: [[1, 0]] }, 2)).toBe(0);
  expect(missingPoints({ kind: 'polygon', points: [[1, 2]] }, 3)).toBe(2);
  expect(missingPoints({ kind: 'barrier', name: 'Net' }, 3)).toBe(0);
});
test('the whole line is moved', () => expect(moved([[1, 2], [3, 4]], 1, -1)).toEqual([[2, 1], [4, 3]]));
