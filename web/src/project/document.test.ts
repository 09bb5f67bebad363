import { beforeEach, describe, expect, test } from 'vitest';
import { begin, edit, endStep, isChanged, leave, markSaved, recordBeside, redo, replaceText, text, undo, undoes, values } from './document';
import { messages } from '../state/messages';

const saved = '[ground]\ndefault = "Rock"\n';
const set = (value: number) => edit('change Rocks', [{ set: ['rocks'], value }], 'rocks');

beforeEach(() => {
  messages.value = [];
  begin('a.toml', saved, saved, 'hash');
});

describe('a step', () => {
  test('combines everything typed into one field', () => {
    [1, 10, 100].forEach(set);
    undo();
    expect(text.value).toBe(saved);
    redo();
    expect(values.value.rocks).toBe(100);
  });
  test('ends when the field is left and when the project is saved', () => {
    set(100);
    endStep();
    set(200);
    markSaved('a.toml', text.value, 'hash 2');
    set(300);
    const seen = [300, 200, 100].map((rocks) => {
      expect(values.value.rocks).toBe(rocks);
      undo();
      return rocks;
    });
    expect([seen.length, text.value]).toEqual([3, saved]);
  });
});

describe('a change beside the text', () => {
  test('is undone and redone in its turn, and changes no text', () => {
    let line = 'none';
    const draw = (to: string) => {
      const before = line;
      line = to;
      recordBeside(`draw ${to}`, () => (line = before), () => (line = to));
    };
    draw('a');
    expect(isChanged.value).toBe(false);
    set(100);
    draw('b');
    expect(undoes.value).toBe('draw b');
    const seen = [1, 2, 3].map(() => {
      undo();
      return [line, values.value.rocks];
    });
    expect(seen).toEqual([['a', 100], ['a', undefined], ['none', undefined]]);
    [1, 2, 3].forEach(redo);
    expect([line, values.value.rocks, text.value === saved]).toEqual(['b', 100, false]);
    undo();
    draw('c'); // instead of b
    redo();
    expect(line).toBe('c');
  });
});

describe('a text that is not valid TOML', () => {
  const broken = `${saved}\n[[broken\n`;
  test('is not changed by forms, which report it once', () => {
    replaceText(broken, 'edit the text');
    expect([set(1), set(10)]).toEqual([false, false]);
    expect(text.value).toBe(broken);
    expect(undoes.value).toBe('edit the text');
    expect(messages.value.map(({ kind, text: shown }) => `${kind}: ${shown}`)).toEqual([
      'error: Could not change Rocks: the text is not valid TOML (line 5: Unterminated table-key). Correct it in the Text tab first',
    ]);
  });
  test('keeps its last valid values', () => {
    expect(values.value).toEqual({ ground: { default: 'Rock' } });
    replaceText(broken, 'edit the text');
    expect(values.value).toEqual({ ground: { default: 'Rock' } });
  });
  test('does not have the values of the previous project', () => {
    expect(values.value).not.toEqual({});
    leave();
    begin('b.toml', broken, broken, 'hash');
    expect(values.value).toEqual({});
    begin('c.toml', broken, broken, 'hash');
    expect(values.value).toEqual({});
  });
});

test('an edit that is not possible is reported', () => {
  expect(edit('draw seeder 1', [{ set: ['seeder', 0, 'position'], value: [0, 0] }])).toBe(false);
  expect(messages.value.map(({ text: shown }) => shown)).toEqual([
    'Could not draw seeder 1: there is no [[seeder]] number 0',
  ]);
});
