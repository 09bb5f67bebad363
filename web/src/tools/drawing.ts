// Drawing in the view: points are clicked one after the other and used together when the drawing is finished.

import { signal } from '@preact/signals';
import { leaveTool, showOverlay, useTool, type Overlay, type Place } from './tool';
import type { Point3 } from '../api/types';
import { model } from '../project/model';

export interface Drawing {
  name: string;
  /// What to click.
  hint: string;
  kind: Overlay['kind'];
  /// The minimum and maximum number of points. Below the maximum, Enter or a double click finishes.
  least: number;
  most?: number;
  isPossible?: () => boolean;
  done: (places: Point3[]) => void;
}

const doubleClick = 400; // ms
/// Whether two clicks are at the same point. The second half of a double click may be slightly off.
function isSame(a: Point3 | undefined, b: Point3, elapsed: number): boolean {
  if (!a) return false;
  const bounds = model.peek()?.bounds;
  const extent = bounds ? Math.hypot(...bounds.max.map((high, k) => high - bounds.min[k]!)) : 0;
  return Math.hypot(...a.map((value, k) => value - b[k]!)) <= (elapsed < doubleClick ? 0.01 * extent : 0);
}

export function draw({ name, hint, kind, least, most = Infinity, isPossible, done }: Drawing) {
  // A signal, because the hint depends on it.
  const places = signal<Point3[]>([]);
  let pointer: Point3 | null = null;
  let clicked = 0;
  const show = () => {
    const points = pointer && places.value.length < most ? [...places.value, pointer] : places.value;
    const line: Overlay[] =
      kind !== 'points' && points.length > 1 ? [{ points, kind: points.length > 2 ? kind : 'line' }] : [];
    showOverlay(
      'drawing',
      places.value.length + line.length > 0 ? [...line, { points: places.value, kind: 'points' }] : [],
    );
  };
  const end = () => {
    showOverlay('drawing', []);
    leaveTool(name);
  };
  const finish = () => {
    if (places.value.length < least) return;
    const taken = places.value;
    end();
    done(taken);
  };
  useTool({
    name,
    isPossible,
    hint: () => {
      if (most === 1) return hint;
      return `${hint} ${places.value.length >= least ? 'Enter or a double click finishes, ' : ''}Backspace removes the last point, Escape cancels.`;
    },
    click({ point }: Place) {
      const elapsed = performance.now() - clicked;
      clicked += elapsed;
      if (isSame(places.value.at(-1), point, elapsed)) return;
      places.value = [...places.value, point];
      if (places.value.length >= most) finish();
      else show();
    },
    move(place) {
      pointer = place?.point ?? null;
      show();
    },
    finish: most === 1 ? undefined : finish,
    cancel: end,
    back() {
      places.value = places.value.slice(0, -1);
      show();
    },
  });
}
