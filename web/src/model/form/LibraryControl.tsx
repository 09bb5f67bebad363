import { useEffect } from 'preact/hooks';
import { valueAt } from '../../state/document';
import { library, loadLibrary } from '../library';
import { put } from '../place';
import { absentText } from '../words';
import { Choice } from './Choice';
import type { Common, FieldProps } from './fieldProps';

/// The material of the library whose values hold where nothing is given, and where they are from.
export function LibraryControl({ field, path, ...common }: FieldProps & Common) {
  useEffect(loadLibrary, []);
  const value = valueAt(path);
  const words = field.type.kind === 'choice' ? field.type.words : [];
  const titles = Object.fromEntries(library.value.map(({ key, name }) => [key, name]));
  const found = library.value.find(({ key }) => key === value);
  return (
    <>
      <Choice
        {...common}
        words={words}
        titles={titles}
        value={value}
        absent={absentText(field)}
        take={(next) => put(path, next, field.title)}
      />
      {found && (
        <p class="faint source">
          {found.source}. <em>{found.checked}.</em>
        </p>
      )}
    </>
  );
}
