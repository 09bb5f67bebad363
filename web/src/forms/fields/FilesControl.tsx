// A file of the project, or several that belong together.

import { valueAt } from '../../project/document';
import type { TomlValue } from '../../toml/format';
import { put } from '../../project/place';
import { FileControl } from './FileControl';
import type { FieldProps } from './fieldProps';

/// One file is written as a text, several as a list.
export const filesValue = (list: readonly TomlValue[]): TomlValue | undefined => (list.length > 1 ? [...list] : list[0]);

export function FilesControl({ field, path }: FieldProps) {
  const value = valueAt(path);
  const list = Array.isArray(value) ? value : value === undefined ? [] : [value];
  const change = (next: readonly TomlValue[]) => put(path, filesValue(next), field.title);
  return (
    <>
      {list.length < 2 && <FileControl field={field} path={path} />}
      {list.length > 1 &&
        list.map((each, index) => (
          <FileControl
            key={index}
            field={field}
            path={[...path, index]}
            entry={{
              value: each,
              name: `${field.title}: file ${index + 1}`,
              take: (next) =>
                change(next === undefined ? list.filter((_, k) => k !== index) : list.map((one, k) => (k === index ? next : one))),
            }}
          />
        ))}
      {list.length > 0 && list.every((each) => each !== '') && (
        <button class="button" onClick={() => change([...list, ''])}>
          Add another file
        </button>
      )}
    </>
  );
}
