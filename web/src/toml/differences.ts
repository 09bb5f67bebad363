// The values that differ between two texts, regardless of comments, order and layout.

import type { TomlTable, TomlValue } from './format';

export interface ValueDifference {
  /// "material.0.roughness_deg"
  key: string;
  here?: TomlValue;
  there?: TomlValue;
}

const isTable = (value: TomlValue | undefined): value is TomlTable =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const isTableList = (value: TomlValue | undefined): value is TomlTable[] =>
  Array.isArray(value) && value.length > 0 && value.every(isTable);

/// Whether two values are equal, regardless of the types of numbers.
export function isSame(a: TomlValue | undefined, b: TomlValue | undefined): boolean {
  if (a === b || (Number.isNaN(a) && Number.isNaN(b))) return true;
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((part, k) => isSame(part, b[k]));
  if (isTable(a) && isTable(b)) {
    const keys = Object.keys(a);
    return keys.length === Object.keys(b).length && keys.every((key) => isSame(a[key], b[key]));
  }
  // number and bigint
  return isNumber(a) && isNumber(b) && a == b;
}
const isNumber = (value: unknown): value is number | bigint => typeof value === 'number' || typeof value === 'bigint';

const byIndex = (list: TomlTable[]): TomlTable => Object.fromEntries(list.entries());

/// Compares tables recursively; a list that is not of tables counts as one value.
export function differencesOf(here: TomlTable, there: TomlTable, path = ''): ValueDifference[] {
  const keys = [...new Set([...Object.keys(here), ...Object.keys(there)])];
  return keys.flatMap((name) => {
    const [a, b] = [here[name], there[name]];
    const key = path ? `${path}.${name}` : name;
    if (isSame(a, b)) return [];
    if (isTable(a) && isTable(b)) return differencesOf(a, b, key);
    if (isTableList(a) && isTableList(b)) return differencesOf(byIndex(a), byIndex(b), key);
    return [{ key, ...(a !== undefined && { here: a }), ...(b !== undefined && { there: b }) }];
  });
}
