// Compares a material of the project with the library of materials.

import type { LibraryMaterial } from '../api/types';
import type { TomlTable, TomlValue } from '../toml/format';
import { constantKind, type KeyOf, type Row } from '../settings/names';
import { isTable } from '../settings/tables';

export interface Likeness {
  /// The entry whose name it has, or whose values it takes.
  of: LibraryMaterial;
  /// The settings that differ from the entry.
  changed: string[];
  /// Whether it has the entry's name.
  isNamedLikeIt: boolean;
}

/// A constant distribution equals its mean.
function meanOnly(value: unknown): unknown {
  if (!isTable(value as TomlValue)) return value;
  const { mean, distribution, ...more } = value as TomlTable;
  return (distribution ?? constantKind) === constantKind && Object.keys(more).length === 0 ? mean : value;
}

/// "Coarse talus 2" also counts as the name of "Coarse talus".
export const isNameOf = (name: unknown, of: string) => typeof name === 'string' && name.toLowerCase().replace(/ \d+$/, '') === of.toLowerCase();

/// Null if the material is unrelated to the library.
export function likeness(material: Row<'material'>, list: readonly LibraryMaterial[]): Likeness | null {
  const named = list.find(({ name }) => isNameOf(material.name, name));
  const of = named ?? list.find(({ key }) => key === material.like);
  if (!of) return null;
  const source = list.find(({ key }) => key === material.like)?.values ?? {};
  const settings = new Set([...Object.keys(of.values), ...Object.keys(source)]);
  for (const key of Object.keys(material) as KeyOf<'material'>[]) if (key !== 'name' && key !== 'like') settings.add(key);
  const isSame = (key: string) =>
    JSON.stringify(meanOnly(material[key as KeyOf<'material'>] ?? source[key])) === JSON.stringify(meanOnly(of.values[key]));
  return { of, changed: [...settings].filter((key) => !isSame(key)), isNamedLikeIt: named !== undefined };
}
