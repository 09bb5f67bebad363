// Assigns a material to each class of a raster or value of an attribute.

import { useState } from 'preact/hooks';
import { edit, valueAt } from '../../project/document';
import { thingOf, materialNames } from '../../project/place';
import { isTable } from '../../settings/tables';
import { Choice } from './Choice';
import type { FieldProps } from './fieldProps';
import { chosenName } from '../../settings/names';

export function NamesControl({ field, path }: FieldProps) {
  const [fresh, setFresh] = useState('');
  const value = valueAt(path);
  const given = isTable(value) ? Object.entries(value) : [];
  const words = materialNames();
  const titles = Object.fromEntries(words.map((word) => [word, word]));
  const head = field.type.kind === 'names' && field.type.whole ? 'Class' : 'Value';
  const add = () => {
    const key = fresh.trim();
    if (key === '' || given.some(([other]) => other === key)) return;
    edit(`add a ${head.toLowerCase()} to ${thingOf(path)}`, [{ set: [...path, chosenName(key)], value: words[0] ?? '' }]);
    setFresh('');
  };
  return (
    <div>
      {given.length > 0 && (
        <table aria-label={field.title}>
          <thead>
            <tr>
              <th scope="col">{head}</th>
              <th scope="col">Material</th>
              <th scope="col">
                <span class="visually-hidden">Delete</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {given.map(([key, name]) => (
              <tr key={key}>
                <th scope="row">{key}</th>
                <td>
                  <Choice
                    label={`Material of ${key}`}
                    words={words}
                    titles={titles}
                    value={name}
                    absent=""
                    take={(next) =>
                      next !== undefined && edit(`assign ${next} to ${key}`, [{ set: [...path, chosenName(key)], value: next }])
                    }
                  />
                </td>
                <td>
                  <button
                    class="mini"
                    aria-label={`Delete ${key}`}
                    title="Delete"
                    onClick={() =>
                      edit(`delete ${key} of ${thingOf(path)}`, [
                        { remove: given.length === 1 ? path : [...path, chosenName(key)] },
                      ])
                    }
                  >
                    ✕
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      <form
        class="row"
        onSubmit={(event) => {
          event.preventDefault();
          add();
        }}
      >
        <input
          aria-label={`New ${head.toLowerCase()}`}
          placeholder={head}
          value={fresh}
          onInput={(event) => setFresh(event.currentTarget.value)}
        />
        <button class="button" disabled={fresh.trim() === ''}>
          Add
        </button>
      </form>
    </div>
  );
}
