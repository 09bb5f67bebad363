// A number that is typed; a decimal comma is accepted.

import { useEffect, useRef, useState } from 'preact/hooks';
import { typedNumber } from '../settings/numbers';

interface Props {
  title: string;
  unit: string;
  value: number | null;
  /// What an empty field stands for.
  empty?: string;
  /// NaN: not a number.
  take: (value: number | null) => void;
}

export function NumberInput({ title, unit, value, empty, take }: Props) {
  const shown = value === null || Number.isNaN(value) ? '' : String(value);
  const [typed, setTyped] = useState(shown);
  const input = useRef<HTMLInputElement>(null);
  // A drag changes the value; what is being typed stays as it is.
  useEffect(() => {
    if (input.current !== document.activeElement) setTyped(shown);
  }, [shown]);
  return (
    <label class="slope-number">
      <span>{title}</span>
      <input
        ref={input}
        type="text"
        inputMode="decimal"
        value={typed}
        placeholder={empty}
        onInput={({ currentTarget: { value: text } }) => {
          setTyped(text);
          const number = typedNumber(text);
          take(number === undefined ? null : typeof number === 'number' ? number : NaN);
        }}
      />
      <span class="unit">{unit}</span>
    </label>
  );
}
