import type { TomlValue } from '../../toml/format';
import { cellText, typedList } from '../../settings/numbers';
import { TypedInput } from '../../ui/TypedInput';

interface Props {
  id: string;
  value: TomlValue | undefined;
  placeholder: string;
  invalid: boolean;
  describedBy?: string;
  take: (value: TomlValue | undefined) => void;
}

/// A list of numbers separated by commas or spaces.
export function ListControl({ value, take, ...rest }: Props) {
  const text = Array.isArray(value) ? value.map(cellText).join(', ') : cellText(value);
  const read = (typed: TomlValue | undefined) =>
    typeof typed !== 'string' ? undefined : typedList(typed);
  return <TypedInput {...rest} isText value={text === '' ? undefined : text} take={(typed) => take(read(typed))} />;
}
