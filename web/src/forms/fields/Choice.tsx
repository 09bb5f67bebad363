import { useState } from 'preact/hooks';
import type { TomlValue } from '../../toml/format';
import { cellText } from '../../settings/numbers';
import { wordText } from '../../settings/words';

interface Props {
  id?: string;
  label?: string;
  words: string[];
  /// Displayed texts, if they differ from the words.
  titles?: Record<string, string>;
  value: TomlValue | undefined;
  /// The text if nothing is chosen; empty if a choice is required.
  absent: string;
  invalid?: boolean;
  describedBy?: string;
  /// One of very many controls: its options are added on focus.
  isOneOfMany?: boolean;
  take: (value: string | undefined) => void;
}

/// A choice of one word. A value of the file is shown even if it is not one of the words.
export function Choice(props: Props) {
  const { id, label, words, titles = {}, value, absent, invalid, describedBy, isOneOfMany = false, take } = props;
  const [isNear, setNear] = useState(!isOneOfMany);
  const now = cellText(value);
  const approach = () => setNear(true);
  const all = !isNear ? [now].filter(Boolean) : now === '' || words.includes(now) ? words : [...words, now];
  return (
    <select
      id={id}
      aria-label={label}
      aria-invalid={invalid ?? false}
      aria-describedby={describedBy}
      value={now}
      onFocus={approach}
      onPointerDown={approach}
      onChange={(event) => take(event.currentTarget.value || undefined)}
    >
      {(absent || now === '') && <option value="">{absent || 'choose…'}</option>}
      {all.map((word) => (
        <option key={word} value={word}>
          {titles[word] ?? wordText(word)}
        </option>
      ))}
    </select>
  );
}
