// How a material of the project stands to the library of materials.

import type { LibraryMaterial } from '../api/types';
import type { TomlTable, TomlValue } from '../toml/format';
import { constantKind, type KeyOf, type Row } from './names';
import { isTable } from './tables';

export interface Likeness {
  /// The entry whose values it takes, or whose name it has.
  of: LibraryMaterial;
  /// Its settings that are not those of that entry.
  changed: string[];
  /// Whether it is called by the entry's name all the same.
  hasItsName: boolean;
}

/// A constant is the same as its number.
function meanOnly(value: unknown): unknown {
  if (!isTable(value as TomlValue)) return value;
  const { mean, distribution, ...more } = value as TomlTable;
  return (distribution ?? constantKind) === constantKind && Object.keys(more).length === 0 ? mean : value;
}

/// "Coarse talus 2" is a name of "Coarse talus", too.
const isNameOf = (name: unknown, of: string) => typeof name === 'string' && name.toLowerCase().replace(/ \d+$/, '') === of.toLowerCase();

/// Null: it has nothing of the library.
export function likeness(material: Row<'material'>, list: readonly LibraryMaterial[]): Likeness | null {
  const named = list.find(({ name }) => isNameOf(material.name, name));
  const of = named ?? list.find(({ key }) => key === material.like);
  if (!of) return null;
  const source = list.find(({ key }) => key === material.like)?.values ?? {};
  const settings = new Set([...Object.keys(of.values), ...Object.keys(source)]);
  for (const key of Object.keys(material) as KeyOf<'material'>[]) if (key !== 'name' && key !== 'like') settings.add(key);
  const isSame = (key: string) =>
    JSON.stringify(meanOnly(material[key as KeyOf<'material'>] ?? source[key])) === JSON.stringify(meanOnly(of.values[key]));
  return { of, changed: [...settings].filter((key) => !isSame(key)), hasItsName: named !== undefined };
}
