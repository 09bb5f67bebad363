import { useEffect } from 'preact/hooks';
import { valueAt } from '../../project/document';
import { library, loadLibrary, titleOf } from '../../project/library';
import { isGivenName } from '../../project/libraryName';
import { put, tableAt, unusedName } from '../../project/place';
import { words as wordsOfNew } from '../../project/things';
import type { TomlValue } from '../../toml/format';
import { absentText } from '../../settings/words';
import { Choice } from './Choice';
import type { Common, FieldProps } from './fieldProps';

/// The choice of a library material, whose values are the defaults of a material, with its sources.
export function LibraryControl({ field, path, ...common }: FieldProps & Common) {
  useEffect(loadLibrary, []);
  const value = valueAt(path);
  const index = Number(path[1]);
  // A material that nobody has named is called as the entry.
  const take = (next: TomlValue | undefined) => {
    const entry = library.value.find(({ key }) => key === next);
    const isGiven = isGivenName(tableAt(['material', index]).name, wordsOfNew.material!, library.value);
    put(path, next, field.title, entry && isGiven ? { name: unusedName('material', entry.name, index) } : {});
  };
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
        take={take}
      />
      {found?.sources.map(({ keys, text, limits, checked }) => (
        <p key={text} class="faint source">
          {keys.map(titleOf).join(', ')}: {text}. {limits}. <em>{checked}.</em>
        </p>
      ))}
    </>
  );
}
