import { useEffect } from 'preact/hooks';
import { library, loadLibrary } from './library';
import { freshName } from './place';
import { rowsOf } from '../state/document';
import { add } from './things';

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
