// The library of materials, and the values that materials of the project take from it.

import { signal } from '@preact/signals';
import { api } from '../api/client';
import type { LibraryMaterial } from '../api/types';
import { attempt } from '../state/messages';
import type { Path } from '../settings/names';
import type { TomlValue } from '../toml/format';
import { tableAt } from './place';
import { fieldOf } from '../settings/declared';
import { valueText } from '../settings/words';

export const library = signal<LibraryMaterial[]>([]);

export function loadLibrary() {
  if (library.value.length === 0) void attempt('library', async () => (library.value = await api.materials()));
}

/// The title of a key of [[material]].
export const titleOf = (key: string) => fieldOf('material', key)?.title ?? key;

/// The value of a material's setting in the library, if the material names one.
export function inheritedAt(path: Path): TomlValue | undefined {
  const { like } = path[0] === 'material' && path.length === 3 ? tableAt(path.slice(0, 2)) : {};
  return library.value.find(({ key }) => key === like)?.values[String(path[2])] as TomlValue | undefined;
}

export function inheritedText(path: Path): string | undefined {
  const value = inheritedAt(path);
  return value === undefined ? undefined : `library ${valueText(value)}`;
}
