// Rows of coordinates, or a file that has them.

import { useState } from 'preact/hooks';
import { valueAt } from '../../state/document';
import { asListed, profile } from '../../section/profile';
import { put } from '../place';
import { FileControl } from './FileControl';
import type { FieldProps } from './fieldProps';
import { RowsControl } from './geometry';

export function RowsOrFileControl({ field, path }: FieldProps) {
  const value = valueAt(path);
  const [wantsFile, wantFile] = useState(false);
  const isFile = typeof value === 'string';
  const isEmpty = value === undefined || (Array.isArray(value) && value.length === 0);
  return (
    <>
      {(isFile || (wantsFile && isEmpty)) && <FileControl field={field} path={path} />}
      {isFile && profile.value && (
        <div class="row">
          <button class="button" onClick={() => put(path, asListed(profile.value!), field.title)}>
            Take the vertices into the project
          </button>
        </div>
      )}
      {!isFile && isEmpty && (
        <label class="check">
          <input type="checkbox" checked={wantsFile} onChange={(event) => wantFile(event.currentTarget.checked)} />
          From a file
        </label>
      )}
      {!isFile && !(wantsFile && isEmpty) && <RowsControl field={field} path={path} />}
    </>
  );
}
