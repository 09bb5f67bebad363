import type { TomlValue } from '../../toml/format';
import { cellText } from '../numbers';
import { wordText } from '../words';

interface Props {
  id?: string;
  label?: string;
  words: string[];
  /// What the words mean to people, where it is not the word.
  titles?: Record<string, string>;
  value: TomlValue | undefined;
  /// What holds where nothing is chosen; empty: something must be.
  absent: string;
  invalid?: boolean;
  describedBy?: string;
  take: (value: string | undefined) => void;
}

/// One word of several. What the file has is shown even where it is none of them.
export function Choice({ id, label, words, titles = {}, value, absent, invalid, describedBy, take }: Props) {
  const now = cellText(value);
  const all = now === '' || words.includes(now) ? words : [...words, now];
  return (
    <select
      id={id}
      aria-label={label}
      aria-invalid={invalid ?? false}
      aria-describedby={describedBy}
      value={now}
      onChange={(event) => take(event.currentTarget.value || undefined)}
    >
      {(absent || now === '') && <option value="">{absent || 'choose …'}</option>}
      {all.map((word) => (
        <option key={word} value={word}>
          {titles[word] ?? wordText(word)}
        </option>
      ))}
    </select>
  );
}
