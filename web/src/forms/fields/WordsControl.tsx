// A choice of several words: true is all of them, false none.

import { valueAt } from '../../project/document';
import type { TomlValue } from '../../toml/format';
import { cellText } from '../../settings/numbers';
import { put } from '../../project/place';
import { chosenWords, wordsValue } from '../../settings/wordChoice';
import { wordText } from '../../settings/words';
import type { FieldProps } from './fieldProps';

export function WordsControl({ field, path, words }: FieldProps & { words: string[] }) {
  const value = valueAt(path) ?? (field.default as TomlValue | undefined);
  const chosen = chosenWords(value, words);
  const unknown = Array.isArray(value) ? value.map(cellText).filter((word) => !words.includes(word)) : [];
  const take = (next: string[]) => put(path, wordsValue(next, words), field.title);
  return (
    <div>
      <div class="row">
        <button class="mini" onClick={() => take(words)}>
          All
        </button>
        <button class="mini" onClick={() => take([])}>
          None
        </button>
      </div>
      {[...words, ...unknown].map((word) => (
        <label key={word} class="check">
          <input
            type="checkbox"
            checked={chosen.includes(word)}
            onChange={(event) => take(event.currentTarget.checked ? [...chosen, word] : chosen.filter((other) => other !== word))}
          />
          {wordText(word)}
        </label>
      ))}
    </div>
  );
}
