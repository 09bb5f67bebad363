import { useState } from 'preact/hooks';
import type { TomlValue } from '../toml/format';
import { cellText, typedNumber } from '../settings/numbers';

export interface TypedInputProps {
  id?: string;
  label?: string;
  value: TomlValue | undefined;
  placeholder?: string;
  invalid?: boolean;
  describedBy?: string;
  words?: string;
  /// A text is stored when the field is left, a number with every key.
  isText?: boolean;
  take: (value: TomlValue | undefined) => void;
  onKeyDown?: (event: KeyboardEvent & { currentTarget: HTMLInputElement }) => void;
  onPaste?: (event: ClipboardEvent) => void;
}

/// An input field. It shows the typed text while typing, otherwise the project's value.
export function TypedInput(props: TypedInputProps) {
  const { value, take, isText = false } = props;
  const [typed, setTyped] = useState<string | null>(null);
  const read = (text: string) => (isText ? (text.trim() === '' ? undefined : text) : typedNumber(text));
  const settle = (text: string) => {
    setTyped(null);
    if (text !== cellText(value)) take(read(text));
  };
  return (
    <input
      id={props.id}
      type="text"
      inputMode={isText ? undefined : 'decimal'}
      class={isText ? 'typed' : 'typed number'}
      autocomplete="off"
      spellcheck={false}
      aria-label={props.label}
      aria-invalid={props.invalid ?? false}
      aria-describedby={props.describedBy}
      list={props.words}
      data-clean={typed === null ? '' : undefined}
      placeholder={props.placeholder}
      value={typed ?? cellText(value)}
      onInput={(event) => {
        const text = event.currentTarget.value;
        setTyped(text);
        const now = isText ? undefined : typedNumber(text);
        if (typeof now !== 'string' && now !== undefined && now !== value) take(now);
      }}
      onChange={(event) => settle(event.currentTarget.value)}
      onBlur={() => setTyped(null)}
      onKeyDown={props.onKeyDown}
      onPaste={props.onPaste}
    />
  );
}
