// The map of the shown run that is draped over the terrain.

import { effect, signal, type ReadonlySignal } from '@preact/signals';
import { getArrays } from '../api/client';
import { results } from '../api/results';
import type { RunMap } from '../api/types';
import { reportFailure } from '../state/messages';
import { hasResults, shown } from '../runs/runs';
import { kept } from '../state/kept';
import { owned } from '../state/owned';
import { ofProject } from '../project/ofProject';
import { displayOf, unitSystem } from '../state/displayUnits';
import type { MapClass } from './classes';
import type { MapHeader } from './header';

export interface ShownMap {
  name: string;
  /// A short phrase.
  meaning: string;
  header: MapHeader;
  /// In the displayed unit; an empty `unit` is a plain number.
  classes: MapClass[];
  unit: string;
  /// Row by row from the south, in that unit; NaN: no rock passed.
  values: Float32Array;
  /// The range of the values.
  least: number;
  greatest: number;
}

/// The maximum number of cells along the longer side.
const pixels = 1024;

/// The name of the map that is draped over the terrain.
export const [drapedMap, drape] = owned(ofProject<string | null>(null));
export const [drapedOpacity, setOpacity] = owned(kept('opacity of the map', 1));

const loaded = signal<ShownMap | null>(null);
/// The draped map, once it is loaded.
export const shownMap: ReadonlySignal<ShownMap | null> = loaded;

function mapOf({ name, meaning, unit: unitOfFile }: RunMap, header: MapHeader, inFile: Float32Array): ShownMap {
  const { unit, per } = displayOf(unitOfFile);
  const classes = header.classes.map(({ from, to, colour }) => ({ from: from / per, to: to === null ? null : to / per, colour }));
  const values = per === 1 ? inFile : inFile.map((value) => value / per);
  let [least, greatest] = [Infinity, -Infinity];
  for (const value of values)
    if (!Number.isNaN(value)) [least, greatest] = [Math.min(least, value), Math.max(greatest, value)];
  return { name, meaning, header, classes, unit, values, least, greatest };
}

effect(() => {
  const [run, name] = [shown.value, drapedMap.value];
  void unitSystem.value; // its unit is that of the map
  if (!run || !hasResults(run) || run.dimension !== 3 || name === null) {
    loaded.value = null;
    return;
  }
  const asking = new AbortController();
  const path = `/api/runs/${encodeURIComponent(run.id)}/maps/${encodeURIComponent(name)}?pixels=${pixels}`;
  Promise.all([getArrays<MapHeader>(path, asking.signal), results.maps(run.id, asking.signal)]).then(
    ([{ header, arrays }, maps]) => {
      const map = maps.find((each) => each.name === name);
      if (!asking.signal.aborted && map) loaded.value = mapOf(map, header, arrays.values as Float32Array);
    },
    (error: unknown) => {
      if (asking.signal.aborted) return;
      loaded.value = null;
      reportFailure(error);
    },
  );
  return () => asking.abort();
});

/// The value at a point on plan; null outside the map and where no rock passed.
export function valueAt({ header, values }: ShownMap, [x, y]: readonly number[]): number | null {
  const column = Math.floor((x! - header.origin[0]) / header.cell[0]);
  const row = Math.floor((y! - header.origin[1]) / header.cell[1]);
  if (column < 0 || row < 0 || column >= header.columns || row >= header.rows) return null;
  const value = values[row * header.columns + column]!;
  return Number.isNaN(value) ? null : value;
}
