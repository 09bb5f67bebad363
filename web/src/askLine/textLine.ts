// A line from a text of points.

import type { Point2 } from '../api/types';
import { numberOf } from '../settings/numbers';
import { readPasted } from '../settings/pasted';

/// The points of a text with x and y in its first two columns, as if it were pasted; null if it has none.
export function pointsOfText(text: string): Point2[] | null {
  // A line needs two columns: commas separate them, unless semicolons, tabs or blanks do.
  const first = readPasted(text);
  const { rows, open } = first.open && first.rows.every((row) => row.length === 1) ? readPasted(text, 'separate columns') : first;
  const points = rows.map(([x = '', y = '']) => [numberOf(x), numberOf(y)]);
  const isNumber = (value: unknown) => typeof value === 'number' && Number.isFinite(value);
  return open || points.length < 2 || !points.every((point) => point.every(isNumber)) ? null : (points as Point2[]);
}
