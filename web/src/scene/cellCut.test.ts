import { expect, test } from 'vitest';
import { cut, cutCells, thinCells } from './cellCut';

// Rows from the south, as tiles have them.
const of = (...rows: number[][]) => Float32Array.from(rows.flat());

const always = (isNorthEast: boolean) => () => isNorthEast;

test('a cell is cut along its diagonal', () => {
  const heights = of([10, 0], [3, 12]);
  expect(cut(heights, 2, 0, 0, true)).toBe('north-east');
  expect(cut(heights, 2, 0, 0, false)).toBe('south-east');
  // Both ends of the diagonal belong to both triangles.
  const shared = (isNorthEast: boolean) => {
    const index = [...cutCells(heights, 2, 2, always(isNorthEast))];
    return [0, 1, 2, 3].filter((node) => index.filter((each) => each === node).length === 2);
  };
  expect(shared(true)).toEqual([0, 3]);
  expect(shared(false)).toEqual([1, 2]);
});
test('each cell has its own diagonal', () => {
  const index = cutCells(of([0, 0, 0], [0, 0, 0]), 3, 2, (column) => column === 1);
  expect([...index.subarray(0, 6)]).toEqual([0, 1, 3, 1, 4, 3]);
  expect([...index.subarray(6)]).toEqual([1, 2, 5, 1, 5, 4]);
});
test('a cell with a node without data has no triangles', () => {
  const heights = of([0, 0, 0], [0, 0, 0], [0, 0, NaN]);
  expect(cut(heights, 3, 1, 1, true)).toBe('hole');
  expect(cutCells(heights, 3, 3, always(true)).length).toBe(3 * 6);
});
test('triangles are anticlockwise from above and fill the cell', () => {
  const heights = of([0, 3, 1], [4, 1, 5], [9, 2, 6]);
  const index = cutCells(heights, 3, 3, (i, j) => i === j);
  const place = (node: number) => [node % 3, Math.floor(node / 3)] as const;
  for (let k = 0; k < index.length; k += 3) {
    const [[ax, ay], [bx, by], [cx, cy]] = [place(index[k]!), place(index[k + 1]!), place(index[k + 2]!)];
    expect((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).toBe(1);
  }
  expect(index.length).toBe(4 * 6);
});

test('a thinned tile covers all of its nodes with data, and its skirt', () => {
  const [across, along] = [11, 8]; // 9 by 6 nodes inside
  const heights = new Float32Array(across * along);
  const area = (index: Uint32Array) => {
    let sum = 0;
    for (let k = 0; k < index.length; k += 3) {
      const [a, b, c] = [0, 1, 2].map((i) => [index[k + i]! % across, Math.floor(index[k + i]! / across)] as const) as [[number, number], [number, number], [number, number]];
      sum += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    return sum;
  };
  const whole = thinCells(heights, across, along, 4);
  expect(area(whole)).toBe((across - 1) * (along - 1));
  expect(whole.length / 3).toBeLessThan(2 * 6 * 5);
  // A hole takes the cells that touch it.
  heights[1 + 4 + across] = NaN;
  expect(area(thinCells(heights, across, along, 4))).toBe((across - 1) * (along - 1) - 8 * 5);
});
