// The map of the shown run that is chosen to lie on the terrain.

import { effect, signal } from '@preact/signals';
import { getArrays } from '../api/client';
import type { Point2 } from '../api/types';
import { sayFailure } from '../state/messages';
import { hasResults, shown } from '../state/runs';
import { drapedMap } from '../state/view';

export interface MapHeader {
  origin: Point2; // the south-western corner
  cell: Point2;
  columns: number;
  rows: number;
  scale: 'linear' | 'log';
  limits: [number, number];
  /// Greater values have the last colour.
  is_open_upwards: boolean;
  /// Colours at values; between two of them a mixture.
  colours: [number, [number, number, number]][];
}

export interface ShownMap {
  name: string;
  header: MapHeader;
  /// Row by row from the south; NaN: no rock was there.
  values: Float32Array;
}

/// The longer side of the picture has at most so many cells.
const pixels = 1024;

export const shownMap = signal<ShownMap | null>(null);

effect(() => {
  const [run, name] = [shown.value, drapedMap.value];
  if (!run || !hasResults(run) || run.dimension !== 3 || name === null) {
    shownMap.value = null;
    return;
  }
  const asking = new AbortController();
  const path = `/api/runs/${encodeURIComponent(run.id)}/maps/${encodeURIComponent(name)}?pixels=${pixels}`;
  getArrays<MapHeader>(path, asking.signal).then(
    ({ header, arrays }) => {
      if (!asking.signal.aborted) shownMap.value = { name, header, values: arrays.values as Float32Array };
    },
    (error: unknown) => {
      if (asking.signal.aborted) return;
      shownMap.value = null;
      sayFailure(error);
    },
  );
  return () => asking.abort();
});

/// The colour of a value: that of the nearest place outside the scale, a mixture within.
export function colourOfValue({ colours, scale }: MapHeader, value: number): [number, number, number] {
  const at = (x: number) => (scale === 'log' ? Math.log(Math.max(x, Number.MIN_VALUE)) : x);
  const after = colours.findIndex(([place]) => place >= value);
  if (after === 0) return colours[0]![1];
  if (after < 0) return colours.at(-1)![1];
  const [[a, from], [b, to]] = [colours[after - 1]!, colours[after]!];
  const share = (at(value) - at(a)) / (at(b) - at(a) || 1);
  return from.map((part, k) => Math.round(part + share * (to[k]! - part))) as [number, number, number];
}
