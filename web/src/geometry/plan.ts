// Coordinates and lengths on plan.

/// Rounds a clicked coordinate to a millimetre, or to a centimetre if the terrain is wide or there is none yet.
export function rounded(value: number, extent: number): number {
  const digits = extent > 200 || extent === 0 ? 2 : 3;
  return Number(value.toFixed(digits));
}

/// The length of a line [m].
export const lengthOf = (line: readonly (readonly [number, number])[]): number =>
  line.slice(1).reduce((sum, [x, y], k) => sum + Math.hypot(x - line[k]![0], y - line[k]![1]), 0);
