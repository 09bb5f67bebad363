// Where things of the project stand in its text, and what they are called.

import { computed } from '@preact/signals';
import { edit, rowsOf, valueAt, values } from '../state/document';
import { model } from '../state/model';
import { defaultOf, type Edit, type Path, type Row, type TableName } from './names';
import type { TomlValue } from '../toml/format';
import { consequences } from './consequences';
import { renaming, type FormerName } from './renames';
import { sections } from './sections';
import { isTable } from './tables';

export { isTable } from './tables';

/// A table of the project; empty where it is not there.
export function tableAt<T extends TableName>(path: readonly [T] | readonly [T, number]): Row<T>;
export function tableAt(path: Path): Row;
export function tableAt(path: Path): Row {
  const value = valueAt(path);
  return isTable(value) ? value : {};
}

/// Whether positions are [x, z]: by what the text says, so that it holds while there is no model.
export const is2d = computed(() => {
  const terrain = tableAt(['terrain']);
  return terrain.section !== undefined && terrain.width_m === undefined;
});
/// What the view shows: the model as it was built last, or what the text is about to become.
export const dimension = computed<2 | 3>(() => model.value?.dimension ?? (is2d.value ? 2 : 3));

/// How the project's rocks move: "lumped_mass", "rigid_sphere".
export const rockModel = computed(() => String(tableAt(['analysis']).model ?? defaultOf('analysis', 'model')));

/// What results and messages call an entry of a list: "Type One", "seeder 2".
export function nameOf(key: TableName, index: number): string {
  const name = rowsOf(key)[index]?.name;
  return typeof name === 'string' && name !== '' ? name : `${key} ${index + 1}`;
}

/// The thing that a path leads to or into, for people: "Type One", "Terrain".
export function thingOf(path: Path): string {
  if (typeof path[1] === 'number') return nameOf(path[0] as TableName, path[1]);
  if (path.length < 2) return 'the project';
  return sections.find(({ name }) => name === path[0])?.title.toLowerCase() ?? String(path[0]);
}

/// The paths that the engine's problems name.
export const pathText = (path: Path) => path.join('.');

let formerNames: FormerName[] = [];

/// Sets a value, or removes its key where there is none.
export function put(path: Path, value: TomlValue | undefined, title: string, merge = pathText(path)) {
  const what = value === undefined ? `clear ${title}` : `change ${title}`;
  const own: Edit = value === undefined ? { remove: path } : { set: path, value };
  const isName = path.length === 3 && path[2] === 'name';
  const called = isName ? renaming(values.value, path, value, formerNames) : { edits: [], known: formerNames };
  const more = [...consequences(values.value, path, value), ...called.edits];
  if (edit(`${what} of ${thingOf(path)}`, [own, ...more], merge)) formerNames = called.known;
}

/// Tells whether the entries of a list are still those of now, by their names: another may have a number by then.
export function asNow(key: TableName): () => boolean {
  const names = () => JSON.stringify(rowsOf(key).map((_, index) => nameOf(key, index)));
  const then = names();
  return () => names() === then;
}

/// A name that no entry of these lists has: "Material 3".
export function freshName(keys: readonly TableName[], word: string): string {
  const taken = new Set(keys.flatMap((key) => rowsOf(key).map((_, index) => nameOf(key, index).toLowerCase())));
  for (let number = 1; ; ++number) {
    if (!taken.has(`${word} ${number}`.toLowerCase())) return `${word} ${number}`;
  }
}
