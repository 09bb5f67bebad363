// What is asked: a line or an area on plan, or a barrier or collector of the run; in 2D a place.

import type { AskedShape } from '../api/line';
import type { Point2 } from '../api/types';

export type Asked = { kind: 'line' | 'polygon'; points: Point2[] } | { kind: 'barrier'; name: string };

/// The number of points that are missing.
export function missingPoints(asked: Asked, dimension: 2 | 3): number {
  if (asked.kind === 'barrier') return 0;
  const least = dimension === 2 ? 1 : asked.kind === 'line' ? 2 : 3;
  return Math.max(0, least - asked.points.length);
}

/// As in a request.
export const shapeOf = (asked: Asked): AskedShape =>
  asked.kind === 'barrier' ? { barrier: asked.name } : asked.kind === 'line' ? { line: asked.points } : { polygon: asked.points };

/// The stored text of what is asked, and back; anything else is null.
export const textOf = (asked: Asked | null): string => (asked ? JSON.stringify(asked) : '');
export function askedOf(text: string): Asked | null {
  try {
    const found = JSON.parse(text) as Asked;
    if (found.kind === 'barrier') return typeof found.name === 'string' ? found : null;
    const isPoint = (point: unknown) => Array.isArray(point) && point.length === 2 && point.every(Number.isFinite);
    return (found.kind === 'line' || found.kind === 'polygon') && found.points.every(isPoint) ? found : null;
  } catch {
    return null;
  }
}

export const moved = (points: readonly Point2[], dx: number, dy: number): Point2[] => points.map(([x, y]) => [x + dx, y + dy]);
