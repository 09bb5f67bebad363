// Paths and names of entries of the project, and setting their values.

import { computed } from '@preact/signals';
import { edit, rowsOf, valueAt, values } from './document';
import { model } from './model';
import { defaultOf, type Edit, type Path, type Row, type TableName } from '../settings/names';
import type { TomlValue } from '../toml/format';
import { consequences } from '../settings/consequences';
import { renaming, type FormerName } from '../settings/renames';
import type { Field } from '../settings/schema';
import { sections } from '../settings/sections';
import { isTable } from '../settings/tables';

/// A table of the project; empty if it does not exist.
export function tableAt<T extends TableName>(path: readonly [T] | readonly [T, number]): Row<T>;
export function tableAt(path: Path): Row;
export function tableAt(path: Path): Row {
  const value = valueAt(path);
  return isTable(value) ? value : {};
}

/// Whether positions are [x, z]; from the text, so that it is known without a model.
export const is2d = computed(() => {
  const terrain = tableAt(['terrain']);
  return terrain.section !== undefined && terrain.width_m === undefined;
});
/// The dimension of the view: that of the last model, or else of the text.
export const dimension = computed<2 | 3>(() => model.value?.dimension ?? (is2d.value ? 2 : 3));

/// The project's rock model: "lumped_mass" or "rigid_sphere".
export const rockModel = computed(() => String(tableAt(['analysis']).model ?? defaultOf('analysis', 'model')));

/// A setting with the default that it has under the project's laws.
export function underLaws(field: Field): Field {
  const standard = field.defaultByLaws[String(tableAt(['analysis']).laws)];
  return standard === undefined ? field : { ...field, default: standard };
}

/// The name of an entry of a list in results and messages: "Type One", "seeder 2".
export function nameOf(key: TableName, index: number): string {
  const name = rowsOf(key)[index]?.name;
  return typeof name === 'string' && name !== '' ? name : `${key} ${index + 1}`;
}

/// The names of all entries of a list.
export const namesOf = (key: TableName): string[] => rowsOf(key).map((_, index) => nameOf(key, index));
export const materialNames = () => namesOf('material');

/// The name of the entry or section of a path: "Type One", "terrain".
export function thingOf(path: Path): string {
  if (typeof path[1] === 'number') return nameOf(path[0] as TableName, path[1]);
  if (path.length < 2) return 'the project';
  return sections.find(({ name }) => name === path[0])?.title.toLowerCase() ?? String(path[0]);
}

/// A path as in the engine's problems: "material.0.name".
export const pathText = (path: Path) => path.join('.');

let formerNames: FormerName[] = [];

/// Sets a value, or removes its key (undefined); with the name of its entry, too, if `name` is given.
/// Changes with the same `merge` in a row are one step of Undo.
export function put(path: Path, value: TomlValue | undefined, title: string, { merge = pathText(path), name }: { merge?: string; name?: string } = {}) {
  const what = value === undefined ? `clear ${title}` : `change ${title}`;
  const own: Edit = value === undefined ? { remove: path } : { set: path, value };
  const namePath: Path = [...path.slice(0, 2), 'name'];
  const isName = path.length === 3 && path[2] === 'name';
  const next = isName ? value : name;
  const renamed = isName || name !== undefined ? renaming(values.value, namePath, next, formerNames) : { edits: [], known: formerNames };
  const more = [...consequences(values.value, path, value), ...(name !== undefined ? [{ set: namePath, value: name }] : []), ...renamed.edits];
  if (edit(`${what} of ${thingOf(path)}`, [own, ...more], merge)) formerNames = renamed.known;
}

/// Returns a function that tells whether the entries of a list are still the same, by their names.
export function entriesUnchanged(key: TableName): () => boolean {
  const names = () => JSON.stringify(namesOf(key));
  const then = names();
  return () => names() === then;
}

/// The name itself, or numbered if another entry of a list has it; `own`: the entry that is to have it.
export function unusedName(key: TableName, name: string, own?: number): string {
  const others = namesOf(key).filter((_, index) => index !== own).map((each) => each.toLowerCase());
  for (let number = 1; ; ++number) {
    const next = number === 1 ? name : `${name} ${number}`;
    if (!others.includes(next.toLowerCase())) return next;
  }
}

/// An unused name for an entry of these lists: "Material 3".
export function freshName(keys: readonly TableName[], word: string): string {
  const taken = new Set(keys.flatMap((key) => namesOf(key).map((name) => name.toLowerCase())));
  for (let number = 1; ; ++number) {
    if (!taken.has(`${word} ${number}`.toLowerCase())) return `${word} ${number}`;
  }
}
