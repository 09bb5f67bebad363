// A notice on a material that is named like a library material but has other values.

import { useEffect } from 'preact/hooks';
import { nameOf, put, tableAt } from '../project/place';
import { rowsOf } from '../project/document';
import type { Path } from '../settings/names';
import { library, loadLibrary, titleOf } from '../project/library';
import { likeness } from '../project/likeness';

/// "Coarse talus, changed", numbered if another material has that name.
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
  const { of, changed, isNamedLikeIt } = found;
  const next = changedName(of.name);
  return (
    <div class="problem warning" role="status">
      <p>
        {isNamedLikeIt ? 'Named like' : 'Based on'} “{of.name}” of the library, with other values of:{' '}
        {changed.map((key) => titleOf(key).toLowerCase()).join(', ')}.
      </p>
      {isNamedLikeIt && (
        <button class="button" onClick={() => put([...path, 'name'], next, 'Name')}>
          Rename to “{next}”
        </button>
      )}
    </div>
  );
}
