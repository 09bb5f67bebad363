import { useEffect } from 'preact/hooks';
import { valueAt } from '../../project/document';
import { library, loadLibrary, titleOf } from '../../project/library';
import { put } from '../../project/place';
import { absentText } from '../../settings/words';
import { Choice } from './Choice';
import type { Common, FieldProps } from './fieldProps';

/// The choice of a library material, whose values are the defaults of a material, with its sources.
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
      {found?.sources.map(({ keys, text, limits, checked }) => (
        <p key={text} class="faint source">
          {keys.map(titleOf).join(', ')}: {text}. {limits}. <em>{checked}.</em>
        </p>
      ))}
    </>
  );
}
