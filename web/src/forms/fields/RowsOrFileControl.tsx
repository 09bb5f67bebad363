// Rows of coordinates, or a file that has them.

import { useState } from 'preact/hooks';
import { edit, valueAt } from '../../project/document';
import { asListed, profile } from '../../project/profile';
import { thingOf } from '../../project/place';
import { FileControl } from './FileControl';
import type { FieldProps } from './fieldProps';
import { RowsControl } from './geometry';

/// Settings that only a file has.
const ofFile = ['section_layer', 'section_tolerance_m'] as const;

export function RowsOrFileControl({ field, path }: FieldProps) {
  const value = valueAt(path);
  const [wantsFile, wantFile] = useState(false);
  const isFile = typeof value === 'string';
  const isEmpty = value === undefined || (Array.isArray(value) && value.length === 0);
  const takeRows = () =>
    edit(`take the ${field.title.toLowerCase()} of ${thingOf(path)} from its file`, [
      { set: path, value: asListed(profile.value!) },
      ...ofFile.map((key) => [path[0]!, key] as const).flatMap((of) => (valueAt(of) === undefined ? [] : [{ remove: of }])),
    ]);
  return (
    <>
      {(isFile || (wantsFile && isEmpty)) && <FileControl field={field} path={path} />}
      {isFile && profile.value && (
        <div class="row">
          <button class="button" onClick={takeRows}>
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
