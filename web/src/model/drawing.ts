// Drawing in the view: places are clicked one after the other, and taken together when the drawing is finished.

import { showOverlay, tool, useTool, type Overlay, type Place } from '../scene/tool';
import type { Point3 } from '../api/types';

interface Drawing {
  name: string;
  /// What one click does.
  hint: string;
  kind: Overlay['kind'];
  /// As many places make it; with more they are drawn until Enter or a double click.
  least: number;
  most?: number;
  done: (places: Point3[]) => void;
}

/// Whether two clicks are one: a double click leaves a second one at the same place.
const isSame = (a: Point3 | undefined, b: Point3) => a !== undefined && a.every((value, k) => value === b[k]);

export function draw({ name, hint, kind, least, most = Infinity, done }: Drawing) {
  let places: Point3[] = [];
  let pointer: Point3 | null = null;
  const show = () => {
    const points = pointer && places.length < most ? [...places, pointer] : places;
    const line: Overlay[] =
      kind !== 'points' && points.length > 1 ? [{ points, kind: points.length > 2 ? kind : 'line' }] : [];
    showOverlay('drawing', places.length + line.length > 0 ? [...line, { points: places, kind: 'points' }] : []);
  };
  const end = () => {
    showOverlay('drawing', []);
    if (tool.value?.name === name) tool.value = null;
  };
  const finish = () => {
    if (places.length < least) return;
    const taken = places;
    end();
    done(taken);
  };
  useTool({
    name,
    hint: () => {
      const missing = least - places.length;
      const keys = 'Backspace takes the last one back, Escape leaves.';
      if (most === 1) return hint;
      if (missing > 0) return `${hint} ${keys}`;
      return `${hint} Enter or a double click finishes. ${keys}`;
    },
    click({ point }: Place) {
      if (isSame(places.at(-1), point)) return;
      places = [...places, point];
      if (places.length >= most) finish();
      else refresh();
    },
    move(place) {
      pointer = place?.point ?? null;
      show();
    },
    finish: most === 1 ? undefined : finish,
    cancel: end,
    back() {
      places = places.slice(0, -1);
      refresh();
    },
  });
  // The hint follows the number of places: the tool is a new one to who shows it.
  function refresh() {
    show();
    if (tool.value) tool.value = { ...tool.value };
  }
}

/// To a millimetre, or a centimetre where the ground is wide: finer than anyone points.
export function rounded(value: number, extent: number): number {
  const digits = extent > 200 ? 2 : 3;
  return Number(value.toFixed(digits));
}
