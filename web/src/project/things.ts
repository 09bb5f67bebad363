// Adds, copies and deletes materials, areas, forests, seeders, barriers and collectors.

import { edit, rowsOf, values } from './document';
import { choose, chosen } from './chosen';
import { defaultOf, type Edit, type KeyOf, type Row, type TableName } from '../settings/names';
import type { TomlTable } from '../toml/format';
import { removal } from '../settings/consequences';
import { tableOf } from '../settings/declared';
import { kindOf } from '../settings/terrainKinds';
import { freshName, is2d, nameOf, tableAt } from './place';

/// What a new entry is called, with a number.
export const words: Partial<Record<TableName, string>> = {
  material: 'Material',
  area: 'Area',
  forest: 'Forest',
  seeder: 'Seeder',
  barrier: 'Barrier',
  collector: 'Collector',
  kit: 'Kit',
  layer: 'Layer',
};
const family = (key: TableName): TableName[] => (key === 'barrier' || key === 'collector' ? ['barrier', 'collector'] : [key]);

/// Initial values of a new entry, in addition to its name. Values that only the user can know are left out.
function first(key: TableName): Row {
  switch (key) {
    case 'seeder':
      return { type: defaultOf('seeder', 'type'), rocks: 50 };
    case 'barrier':
    case 'collector':
      return { height_m: 3 };
    default:
      return {};
  }
}

/// Adds an entry as one step. Returns false if that is not possible.
export function append(key: TableName, more: Row = {}, what = `add a ${key}`, comment?: string): boolean {
  const value = { name: freshName(family(key), words[key] ?? key), ...first(key), ...more };
  const ground = key === 'material' && rowsOf(key).length === 1 ? defaultGround() : [];
  return edit(what, [{ append: [key], value, ...(comment !== undefined && { comment }) }, ...ground]);
}

/// Adds an entry as one step and opens its form.
export function add(key: TableName, more: Row = {}, what?: string) {
  const index = rowsOf(key).length;
  if (append(key, more, what)) choose([key, index]);
}

/// With a second material the ground needs a default material, unless materials are already assigned.
function defaultGround(): Edit[] {
  const ground = tableAt(['ground']);
  const isAssigned = (['default', ...tableOf('ground')!.choices[0]!.flat()] as KeyOf<'ground'>[]).some((key) => ground[key] !== undefined);
  return isAssigned ? [] : [{ set: ['ground', 'default'], value: nameOf('material', 0) }];
}

export function copy(key: TableName, index: number) {
  const row = rowsOf(key)[index];
  if (!row) return;
  add(key, { ...row, name: freshName(family(key), nameOf(key, index)) }, `copy ${nameOf(key, index)}`);
}

export function remove(key: TableName, index: number) {
  const isDone = edit(`delete ${nameOf(key, index)}`, removal(values.value, [key, index]));
  if (isDone && chosen.value?.[0] === key) choose(null);
}

export interface Step {
  key: 'terrain' | 'material' | 'seeder';
  what: string;
}

/// What a project still needs before it can run, in the recommended order.
export function nextSteps(project: TomlTable): Step[] {
  const terrain = project.terrain as Row<'terrain'> | undefined;
  const kind = terrain && kindOf(terrain);
  const hasSurface = kind !== undefined && kind.name !== 'section';
  const section = terrain?.section;
  const isEmpty = (key: TableName) => project[key] === undefined || (project[key] as unknown[]).length === 0;
  const steps: Step[] = [];
  if (!hasSurface && !(Array.isArray(section) && section.length >= 2))
    steps.push({
      key: 'terrain',
      what:
        section !== undefined && is2d.value
          ? 'The slope has no vertices yet: draw them, or type or paste them into a table.'
          : 'No terrain yet: choose a file, or draw it.',
    });
  if (isEmpty('material')) steps.push({ key: 'material', what: 'No material yet: what is the ground made of?' });
  if (isEmpty('seeder')) steps.push({ key: 'seeder', what: 'No seeder yet: where do rocks start?' });
  return steps;
}
