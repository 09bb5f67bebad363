// The drawn size of rocks: the true size, but at least a visible minimum, which is larger for larger rocks.

/// The minimum radius of the largest rock [CSS pixels]; smaller for many rocks, which would cover each other.
export const leastRadius = (count: number): number => (count > 3000 ? 1.8 : count > 300 ? 2.6 : 3.6);
/// The minimum radius of a rock of size 0, as a share of `leastRadius`.
export const leastShare = 0.55;

/// The drawn radius [pixels]; `radius` and `largest` are in metres.
export function drawnRadius(radius: number, largest: number, pixelsPerMetre: number, least: number): number {
  const share = largest > 0 ? radius / largest : 1;
  return Math.max(radius * pixelsPerMetre, least * (leastShare + (1 - leastShare) * share));
}

/// The radius of marks at points with this mean spacing, so that they do not overlap [pixels].
export const markRadius = (spacing: number, maximum: number): number =>
  Math.max(1, Math.min(maximum, 0.36 * spacing));

/// The mean spacing of points along a line or over an area, in their unit; Infinity for a single point.
export function meanSpacing(places: readonly (readonly number[])[]): number {
  if (places.length < 2) return Infinity;
  const spans = places[0]!.map((_, axis) => {
    const along = places.map((at) => at[axis]!);
    return along.reduce((a, b) => Math.max(a, b)) - along.reduce((a, b) => Math.min(a, b));
  });
  const [longest = 0, second = 0] = spans.toSorted((a, b) => b - a);
  return Math.max(longest / (places.length - 1), Math.sqrt((longest * second) / places.length));
}
