import { useEffect } from 'preact/hooks';
import { signal } from '@preact/signals';
import { api } from '../api/client';
import type { LibraryMaterial } from '../api/types';
import { sayFailure } from '../state/messages';
import { freshName } from './place';
import { rowsOf } from '../state/document';
import { add } from './things';

export const library = signal<LibraryMaterial[]>([]);

export function loadLibrary() {
  if (library.value.length === 0) void api.materials().then((list) => (library.value = list), sayFailure);
}

/// A new material with the values of one of the library.
export function LibraryChoice() {
  useEffect(loadLibrary, []);
  const take = (key: string) => {
    const found = library.value.find((entry) => entry.key === key);
    if (!found) return;
    const isTaken = rowsOf('material').some(({ name }) => name === found.name);
    add(
      'material',
      { name: isTaken ? freshName(['material'], found.name) : found.name, like: key },
      `add ${found.name}`,
    );
  };
  return (
    <select
      class="plain"
      aria-label="Add a material of the library"
      value=""
      onChange={(event) => {
        take(event.currentTarget.value);
        event.currentTarget.value = '';
      }}
    >
      <option value="">+ From the library…</option>
      {library.value.map(({ key, name }) => (
        <option key={key} value={key}>
          {name}
        </option>
      ))}
    </select>
  );
}
