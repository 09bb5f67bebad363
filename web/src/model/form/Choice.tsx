import { useState } from 'preact/hooks';
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
  /// One of very many: its other words come when somebody is about to choose.
  isOneOfMany?: boolean;
  take: (value: string | undefined) => void;
}

/// One word of several. What the file has is shown even where it is none of them.
export function Choice(props: Props) {
  const { id, label, words, titles = {}, value, absent, invalid, describedBy, isOneOfMany = false, take } = props;
  const [isNear, approach] = useState(!isOneOfMany);
  const now = cellText(value);
  const near = () => approach(true);
  const all = !isNear ? [now].filter(Boolean) : now === '' || words.includes(now) ? words : [...words, now];
  return (
    <select
      id={id}
      aria-label={label}
      aria-invalid={invalid ?? false}
      aria-describedby={describedBy}
      value={now}
      onFocus={near}
      onPointerDown={near}
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
