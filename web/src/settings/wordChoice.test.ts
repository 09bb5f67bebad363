import { describe, expect, test } from 'vitest';
import { chosenWords, wordsValue } from './wordChoice';

const words = ['passages', 'velocity', 'impacts'];

describe('a choice of words', () => {
  test('is all of them, none, or a list', () => {
    expect(chosenWords(true, words)).toEqual(words);
    expect(chosenWords(false, words)).toEqual([]);
    expect(chosenWords(undefined, words)).toEqual([]);
    expect(chosenWords(['velocity'], words)).toEqual(['velocity']);
  });
  test('is written as true, false, or in the order of the words', () => {
    expect(wordsValue(['impacts', 'velocity', 'passages'], words)).toBe(true);
    expect(wordsValue([], words)).toBe(false);
    expect(wordsValue(['impacts', 'passages'], words)).toEqual(['passages', 'impacts']);
  });
  test('keeps unknown words', () => {
    expect(chosenWords(['energy'], words)).toEqual(['energy']);
    expect(wordsValue(['energy', 'velocity'], words)).toEqual(['velocity', 'energy']);
    expect(wordsValue([...words, 'energy'], words)).toEqual([...words, 'energy']);
  });
});
