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

/// As text, for the browser and addresses: "line~15,0~15,50", "barrier~Net"; and back. Anything else is null.
export function textOf(asked: Asked | null): string {
  if (!asked) return '';
  return asked.kind === 'barrier' ? `barrier~${asked.name}` : [asked.kind, ...asked.points.map(([x, y]) => `${x},${y}`)].join('~');
}
export function askedOf(text: string): Asked | null {
  const [kind = '', ...parts] = text.split('~');
  if (kind === 'barrier') return parts.length > 0 ? { kind, name: parts.join('~') } : null;
  if (kind !== 'line' && kind !== 'polygon') return null;
  const points = parts.map((part) => part.split(',').map((number) => (number === '' ? NaN : Number(number))));
  return points.every((point) => point.length === 2 && point.every(Number.isFinite)) ? { kind, points: points as Point2[] } : null;
}

export const moved = (points: readonly Point2[], dx: number, dy: number): Point2[] => points.map(([x, y]) => [x + dx, y + dy]);

/// "Road", "the asked line", "x = 15.2 m".
export function placeName(of: Asked, dimension: 2 | 3): string {
  if (of.kind === 'barrier') return of.name;
  if (of.kind === 'polygon') return 'the asked area';
  return dimension === 2 ? `x = ${Number(of.points[0]![0].toFixed(2))} m` : 'the asked line';
}
/// The same as a label: "Asked line".
export const placeLabel = (of: Asked, dimension: 2 | 3): string => (of.kind === 'barrier' ? of.name : placeName(of, dimension).replace('the asked', 'Asked'));
