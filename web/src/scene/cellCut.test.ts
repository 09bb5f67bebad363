import { expect, test } from 'vitest';
import { cut, cutCells } from './cellCut';

// Rows from the south, as tiles have them.
const of = (...rows: number[][]) => Float32Array.from(rows.flat());

test('a cell is cut along the diagonal with the smaller height difference', () => {
  expect(cut(of([10, 0], [3, 12]), 2, 0, 0)).toBe('north-east');
  expect(cut(of([0, 10], [12, 3]), 2, 0, 0)).toBe('south-east');
});
test('with equal differences it is cut from south-west to north-east', () => {
  expect(cut(of([0, 1], [2, 3]), 2, 0, 0)).toBe('south-east'); // 3 and 1
  expect(cut(of([0, 0], [1, 1]), 2, 0, 0)).toBe('north-east'); // 1 and 1
  expect(cut(of([5, 5], [5, 5]), 2, 0, 0)).toBe('north-east');
});
test('rotating a cell by 90 degrees rotates its cut', () => {
  // A raised corner belongs to a single triangle, wherever it is.
  const alone = (raised: number) => {
    const heights = new Float32Array(4);
    heights[raised] = 7;
    return [...cutCells(heights, 2, 2)].filter((node) => node === raised).length;
  };
  expect([0, 1, 2, 3].map(alone)).toEqual([1, 1, 1, 1]);
});
test('heights are compared in single precision', () => {
  // In double precision 0.1 + 0.2 lies above 0.3; in a tile both are the same number.
  expect(cut(of([0, 0], [0.3, 0.1 + 0.2]), 2, 0, 0)).toBe('north-east');
  expect(cut(of([2 ** 24, 0], [0.5, 2 ** 24 + 1]), 2, 0, 0)).toBe('north-east');
});
test('a cell with a node without data has no triangles', () => {
  const heights = of([0, 0, 0], [0, 0, 0], [0, 0, NaN]);
  expect(cut(heights, 3, 1, 1)).toBe('hole');
  expect(cutCells(heights, 3, 3).length).toBe(3 * 6);
});
test('triangles are anticlockwise from above and fill the cell', () => {
  const heights = of([0, 3, 1], [4, 1, 5], [9, 2, 6]);
  const index = cutCells(heights, 3, 3);
  const place = (node: number) => [node % 3, Math.floor(node / 3)] as const;
  for (let k = 0; k < index.length; k += 3) {
    const [[ax, ay], [bx, by], [cx, cy]] = [place(index[k]!), place(index[k + 1]!), place(index[k + 2]!)];
    expect((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).toBe(1);
  }
  expect(index.length).toBe(4 * 6);
});
