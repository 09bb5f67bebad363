// Some of a few words as a value of the file: true stands for all, false for none, and a list has them in the order in
// which they are declared.

import type { TomlValue } from '../toml/format';
import { cellText } from './numbers';

/// Those that are chosen, and what else a list has.
export function chosenWords(value: TomlValue | undefined, words: string[]): string[] {
  if (Array.isArray(value)) return value.map(cellText);
  return value === true ? words : [];
}

export function wordsValue(chosen: string[], words: string[]): TomlValue {
  const unknown = chosen.filter((word) => !words.includes(word));
  const known = words.filter((word) => chosen.includes(word));
  if (unknown.length === 0 && known.length === words.length) return true;
  return unknown.length + known.length > 0 && [...known, ...unknown];
}
