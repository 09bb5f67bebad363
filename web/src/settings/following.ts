// Keeps incomplete rows with their setting while entries of lists are added and deleted.

import { isSame } from '../toml/differences';
import type { TomlTable, TomlValue } from '../toml/format';
import { cellsOf } from './rows';
import { isSameRow, withWaiting, type Waiting } from './waitingRows';

/// By the path of the setting: "terrain.section", "seeder.0.position".
export type Unfinished = Record<string, readonly Waiting[]>;

/// The index of an entry of a list after the list changed; null if it was deleted.
export function placeAfter(before: readonly TomlValue[], after: readonly TomlValue[], place: number): number | null {
  if (before.length === after.length) return place;
  const own = before[place];
  // A new entry that is still being typed is after all others.
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

/// Incomplete rows after a change of the project: they move with their entry and are dropped with it.
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

/// Drops rows that change a value which is now another one: undone, drawn in the view, or reloaded.
export function stillOpen(rows: Unfinished, values: TomlTable): Unfinished {
  const left = Object.entries(rows).flatMap(([path, list]) => {
    const value = listAt(values, path.split('.'));
    const width = list[0]?.cells.length ?? 0;
    const isOneRow = value.length > 0 && !Array.isArray(value[0]);
    const given = cellsOf(isOneRow ? [value] : value, width);
    const shown = new Set(withWaiting(given, list).map(({ cells }) => cells));
    const open = list.filter(({ cells, replaces }) => shown.has(cells) && (!isOneRow || isSameRow(replaces, given[0]!)));
    return open.length > 0 ? [[path, open] as const] : [];
  });
  return Object.fromEntries(left);
}
