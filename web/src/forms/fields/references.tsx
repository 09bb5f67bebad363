// Settings that refer to other entries of the project: materials, barriers, collectors.

import { valueAt } from '../../project/document';
import { materialNames, namesOf, put } from '../../project/place';
import { absentText } from '../../settings/words';
import { cellText } from '../../settings/numbers';
import { Choice } from './Choice';
import type { Common, FieldProps } from './fieldProps';
import type { KeyOf, TableName } from '../../settings/names';

/// Settings that are the name of another entry.
export const materialFields: ReadonlySet<string> = new Set<`${TableName}.${KeyOf}`>(['ground.default', 'area.material', 'design.protect']);

export function NameChoice({ field, path, ...common }: FieldProps & Common) {
  const words = path[0] === 'design' ? namesOf('collector') : materialNames();
  const titles = Object.fromEntries(words.map((word) => [word, word]));
  return (
    <Choice
      {...common}
      words={words}
      titles={titles}
      value={valueAt(path)}
      absent={absentText(field)}
      take={(next) => put(path, next, field.title)}
    />
  );
}

/// A choice of several barriers and collectors.
export function NameList({ field, path }: FieldProps) {
  const value = valueAt(path);
  const given = Array.isArray(value) ? value.map(cellText) : [];
  const words = [...namesOf('barrier'), ...namesOf('collector')];
  const unknown = given.filter((name) => !words.includes(name));
  if (words.length === 0 && unknown.length === 0) return <p class="faint">There are no barriers and collectors yet.</p>;
  return (
    <div>
      {given.length === 0 && <p class="faint">{absentText(field)}</p>}
      {[...words, ...unknown].map((name) => (
        <label key={name} class="check">
          <input
            type="checkbox"
            checked={given.includes(name)}
            onChange={(event) => {
              const next = event.currentTarget.checked ? [...given, name] : given.filter((other) => other !== name);
              put(path, next.length > 0 ? next : undefined, field.title);
            }}
          />
          {name}
        </label>
      ))}
    </div>
  );
}
