// Rows that wait stay with their setting while entries of lists come and go.

import { isSame } from '../toml/differences';
import type { TomlTable, TomlValue } from '../toml/format';
import { cellsOf } from './rows';
import { isSameRow, withWaiting, type Waiting } from './waitingRows';

/// By the path of the setting: "terrain.section", "seeder.0.position".
export type Unfinished = Record<string, readonly Waiting[]>;

/// Where an entry of a list is once the list is another one; null: it is gone.
export function placeAfter(before: readonly TomlValue[], after: readonly TomlValue[], place: number): number | null {
  if (before.length === after.length) return place;
  const own = before[place];
  // One that is only being typed stands behind all others.
  if (own === undefined) return place + Math.min(0, after.length - before.length);
  const isOwn = (entry: TomlValue) => isSame(entry, own);
  const rank = before.slice(0, place).filter(isOwn).length;
  return after.flatMap((entry, k) => (isOwn(entry) ? [k] : []))[rank] ?? null;
}

const valueIn = (values: TomlTable, path: string[]) =>
  path.reduce<TomlValue | undefined>((at, part) => (at as TomlTable | undefined)?.[part], values);
const listAt = (values: TomlTable, path: string[]): TomlValue[] => {
  const found = valueIn(values, path);
  return Array.isArray(found) ? found : [];
};

/// Rows follow their entry when another one of its list is taken out, and go with it.
export function following(rows: Unfinished, before: TomlTable, after: TomlTable): Unfinished {
  const moved = Object.entries(rows).flatMap(([path, list]) => {
    const parts = path.split('.');
    const k = parts.findIndex((part) => /^\d+$/.test(part));
    if (k < 0) return [[path, list] as const];
    const above = parts.slice(0, k);
    const place = placeAfter(listAt(before, above), listAt(after, above), Number(parts[k]));
    return place === null ? [] : [[parts.with(k, String(place)).join('.'), list] as const];
  });
  return Object.fromEntries(moved);
}

/// Without those that were begun over something that is another by now: undone, drawn in the view, read again.
export function stillOpen(rows: Unfinished, values: TomlTable): Unfinished {
  const left = Object.entries(rows).flatMap(([path, list]) => {
    const value = listAt(values, path.split('.'));
    const width = list[0]?.cells.length ?? 0;
    const isOneRow = value.length > 0 && !Array.isArray(value[0]);
    const given = cellsOf(isOneRow ? [value] : value, width);
    const shown = new Set(withWaiting(given, list).map(({ cells }) => cells));
    const open = list.filter(({ cells, over }) => shown.has(cells) && (!isOneRow || isSameRow(over, given[0]!)));
    return open.length > 0 ? [[path, open] as const] : [];
  });
  return Object.fromEntries(left);
}
