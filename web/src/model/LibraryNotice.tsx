// What a material still has of the library by whose name it is called.

import { useEffect } from 'preact/hooks';
import { nameOf, put, tableAt } from './place';
import { rowsOf } from '../state/document';
import type { Path } from './names';
import { library, loadLibrary } from './library';
import { likeness } from './likeness';
import { fieldOf } from './settings';

const titleOf = (key: string) => fieldOf('material', key)?.title.toLowerCase() ?? key;

/// "Coarse talus, changed", or the first such name that no other material has.
function changedName(name: string): string {
  const taken = new Set(rowsOf('material').map((_, index) => nameOf('material', index).toLowerCase()));
  for (let number = 1; ; ++number) {
    const next = `${name}, changed${number > 1 ? ` ${number}` : ''}`;
    if (!taken.has(next.toLowerCase())) return next;
  }
}

export function LibraryNotice({ path }: { path: Path }) {
  useEffect(loadLibrary, []);
  const found = likeness(tableAt(path), library.value);
  if (!found || found.changed.length === 0) return null;
  const { of, changed, hasItsName } = found;
  const next = changedName(of.name);
  return (
    <div class="problem warning" role="status">
      <p>
        {hasItsName ? `It has the name of “${of.name}” of the library, but other values` : `Other than “${of.name}” of the library`}:{' '}
        {changed.map(titleOf).join(', ')}.
      </p>
      {hasItsName && (
        <button class="button" onClick={() => put([...path, 'name'], next, 'Name')}>
          Call it “{next}”
        </button>
      )}
    </div>
  );
}
