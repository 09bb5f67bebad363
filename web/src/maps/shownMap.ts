// The map of the shown run that is chosen to lie on the terrain.

import { effect, signal } from '@preact/signals';
import { getArrays } from '../api/client';
import { results } from '../api/results';
import type { RunMap } from '../api/types';
import { sayFailure } from '../state/messages';
import { hasResults, shown } from '../state/runs';
import { drapedMap } from '../state/view';
import { readingOf } from '../results/columns';
import type { MapClass } from './classes';
import type { MapHeader } from './header';

export interface ShownMap {
  name: string;
  /// One phrase.
  meaning: string;
  header: MapHeader;
  /// In the unit in which the map is read; empty: a number.
  classes: MapClass[];
  unit: string;
  /// Row by row from the south, in that unit; NaN: no rock was there.
  values: Float32Array;
  /// Of the values.
  least: number;
  greatest: number;
}

/// The longer side of the picture has at most so many cells.
const pixels = 1024;

export const shownMap = signal<ShownMap | null>(null);

function mapOf({ name, meaning, unit: unitOfFile }: RunMap, header: MapHeader, inFile: Float32Array): ShownMap {
  const { unit, per } = readingOf(unitOfFile);
  const values = per === 1 ? inFile : inFile.map((value) => value / per);
  let [least, greatest] = [Infinity, -Infinity];
  for (const value of values)
    if (!Number.isNaN(value)) [least, greatest] = [Math.min(least, value), Math.max(greatest, value)];
  return { name, meaning, header, classes: header.classes, unit, values, least, greatest };
}

effect(() => {
  const [run, name] = [shown.value, drapedMap.value];
  if (!run || !hasResults(run) || run.dimension !== 3 || name === null) {
    shownMap.value = null;
    return;
  }
  const asking = new AbortController();
  const path = `/api/runs/${encodeURIComponent(run.id)}/maps/${encodeURIComponent(name)}?pixels=${pixels}`;
  Promise.all([getArrays<MapHeader>(path, asking.signal), results.maps(run.id, asking.signal)]).then(
    ([{ header, arrays }, maps]) => {
      const map = maps.find((each) => each.name === name);
      if (!asking.signal.aborted && map) shownMap.value = mapOf(map, header, arrays.values as Float32Array);
    },
    (error: unknown) => {
      if (asking.signal.aborted) return;
      shownMap.value = null;
      sayFailure(error);
    },
  );
  return () => asking.abort();
});

/// At a place on plan; null: beside the map, or no rock was there.
export function valueAt({ header, values }: ShownMap, [x, y]: readonly number[]): number | null {
  const column = Math.floor((x! - header.origin[0]) / header.cell[0]);
  const row = Math.floor((y! - header.origin[1]) / header.cell[1]);
  if (column < 0 || row < 0 || column >= header.columns || row >= header.rows) return null;
  const value = values[row * header.columns + column]!;
  return Number.isNaN(value) ? null : value;
}
