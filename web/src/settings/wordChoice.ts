// A choice of several words as a value of the file: true is all, false is none, and a list has them in the declared order.

import type { TomlValue } from '../toml/format';
import { cellText } from './numbers';

/// The chosen words, including unknown ones of a list.
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
