// How large rocks are drawn: as large as they are, but never so small that they are not seen. Among those that are
// drawn larger than they are, larger rocks are still larger.

/// Of the largest rock's disc, in CSS pixels; of many rocks less, since they would cover each other.
export const leastRadius = (count: number): number => (count > 3000 ? 1.8 : count > 300 ? 2.6 : 3.6);
/// Of the least radius, the share that the smallest rock has, too.
export const leastShare = 0.55;

/// In pixels. `radius` and that of the largest rock in metres.
export function drawnRadius(radius: number, largest: number, pixelsPerMetre: number, least: number): number {
  const share = largest > 0 ? radius / largest : 1;
  return Math.max(radius * pixelsPerMetre, least * (leastShare + (1 - leastShare) * share));
}

/// In pixels, of marks of places so far apart on the average: they never run together.
export const markRadius = (apart: number, most: number): number => Math.max(1, Math.min(most, 0.36 * apart));

/// How far places are apart on the average, along a line or over an area, in their unit; Infinity for one place.
export function meanSpacing(places: readonly (readonly number[])[]): number {
  if (places.length < 2) return Infinity;
  const spans = places[0]!.map((_, axis) => {
    const along = places.map((at) => at[axis]!);
    return along.reduce((a, b) => Math.max(a, b)) - along.reduce((a, b) => Math.min(a, b));
  });
  const [longest = 0, second = 0] = spans.toSorted((a, b) => b - a);
  return Math.max(longest / (places.length - 1), Math.sqrt((longest * second) / places.length));
}
