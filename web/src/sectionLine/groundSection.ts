// Evaluates a ground section from the server.

import type { GroundSection, Point3 } from '../api/types';

/// The continuous polylines between holes and the edge of the terrain.
export function piecesOf({ x_m, y_m, z_m }: GroundSection): Point3[][] {
  const pieces: Point3[][] = [[]];
  z_m.forEach((z, k) => {
    if (z !== null) pieces.at(-1)!.push([x_m[k]!, y_m[k]!, z]);
    else if (pieces.at(-1)!.length > 0) pieces.push([]);
  });
  return pieces.filter((piece) => piece.length > 1);
}

/// The parts of the line without terrain, from and to [m]; null: to its end.
export function gapsOf({ distance_m, z_m }: GroundSection): [number, number | null][] {
  const gaps: [number, number | null][] = [];
  let from: number | null = null;
  z_m.forEach((z, k) => {
    if (z === null) from ??= distance_m[k]!;
    else if (from !== null) {
      gaps.push([from, distance_m[k]!]);
      from = null;
    }
  });
  if (from !== null) gaps.push([from, null]);
  return gaps;
}

type Range = [number, number];
/// Ranges with the same scale on both axes that include the given ones in a plot of this size [pixels]. The line starts
/// at the left; heights are centred.
export function equalRanges([left, right]: Range, [low, high]: Range, width: number, height: number): [Range, Range] {
  const metresPerPixel = Math.max((right - left) / width, (1.08 * (high - low)) / height, 1e-6);
  const [middle, half] = [(low + high) / 2, (metresPerPixel * height) / 2];
  return [
    [left, left + metresPerPixel * width],
    [middle - half, middle + half],
  ];
}
