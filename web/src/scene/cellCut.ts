// Cuts the cells of a raster into triangles along the diagonals that the engine has chosen (docs/terrain.md), so that
// the finest tiles are the simulated surface.

/// The diagonal towards the north-east or the south-east; a cell with a node without data is a hole.
export type Cut = 'north-east' | 'south-east' | 'hole';

type Corners = readonly [number, number, number];
/// The triangles of a cell; its corners are 0 south-west, 1 south-east, 2 north-west, 3 north-east.
export const trianglesOf: Record<Exclude<Cut, 'hole'>, readonly [Corners, Corners]> = {
  'north-east': [
    [0, 1, 3],
    [0, 3, 2],
  ],
  'south-east': [
    [0, 1, 2],
    [1, 3, 2],
  ],
};

/// The cut of the cell north-east of a node; a row has `across` nodes.
export function cut(heights: Float32Array, across: number, column: number, row: number, isNorthEast: boolean): Cut {
  const south = row * across + column;
  const [sw, se] = [heights[south]!, heights[south + 1]!];
  const [nw, ne] = [heights[south + across]!, heights[south + across + 1]!];
  if (Number.isNaN(sw + se + nw + ne)) return 'hole';
  return isNorthEast ? 'north-east' : 'south-east';
}

/// The triangles of all cells of `across` x `along` nodes, as node indices.
export function cutCells(
  heights: Float32Array,
  across: number,
  along: number,
  isNorthEast: (column: number, row: number) => boolean,
): Uint32Array {
  const index = new Uint32Array(6 * (across - 1) * (along - 1));
  let k = 0;
  for (let j = 0; j + 1 < along; ++j)
    for (let i = 0; i + 1 < across; ++i) {
      const way = cut(heights, across, i, j, isNorthEast(i, j));
      if (way === 'hole') continue;
      for (const corners of trianglesOf[way])
        for (const corner of corners) index[k++] = (j + (corner >> 1)) * across + i + (corner % 2);
    }
  return index.subarray(0, k);
}

/// Some nodes of a side of a tile with a skirt: those of the skirt, every `step`th between them, and both ends.
function someNodes(count: number, step: number): number[] {
  const nodes = [0];
  for (let k = 1; k < count - 2; k += step) nodes.push(k);
  return [...nodes, count - 2, count - 1];
}

/// The triangles between every `step`th node along both sides; where a corner has no data, none.
export function thinCells(heights: Float32Array, across: number, along: number, step: number): Uint32Array {
  const [columns, rows] = [someNodes(across, step), someNodes(along, step)];
  const index: number[] = [];
  for (let r = 0; r + 1 < rows.length; ++r)
    for (let c = 0; c + 1 < columns.length; ++c) {
      const [south, north] = [rows[r]! * across, rows[r + 1]! * across];
      const [a, b, d, e] = [south + columns[c]!, south + columns[c + 1]!, north + columns[c]!, north + columns[c + 1]!];
      if (Number.isNaN(heights[a]! + heights[b]! + heights[d]! + heights[e]!)) continue;
      index.push(a, b, e, a, e, d);
    }
  return Uint32Array.from(index);
}
