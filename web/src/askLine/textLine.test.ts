import { expect, test } from 'vitest';
import { pointsOfText } from './textLine';

test('a text of points: the first two columns, in their order', () => {
  expect(pointsOfText('x_m,y_m,z_m\n10,20,3\n11.5,-4,2\n')).toEqual([[10, 20], [11.5, -4]]);
  expect(pointsOfText('1;2,5\n3;4,25\n')).toEqual([[1, 2.5], [3, 4.25]]);
  expect(pointsOfText('1 2\n3 4\n5 6')).toHaveLength(3);
  expect(pointsOfText('x_m,y_m\n15,5\n15,45\n')).toEqual([[15, 5], [15, 45]]);
});
test('anything else is no line', () => {
  expect(pointsOfText('')).toBeNull();
  expect(pointsOfText('1 2\n')).toBeNull();
  expect(pointsOfText('1\n2\n')).toBeNull();
  expect(pointsOfText('a b\nc d')).toBeNull();
  expect(pointsOfText('1,250;2\n2,500;3')).toBeNull(); // thousands or decimals?
});
