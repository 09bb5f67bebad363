import { beforeEach, describe, expect, test } from 'vitest';
import { begin, edit, endStep, leave, redo, replaceText, settle, text, undo, undoes, values } from './document';
import { messages } from './messages';

const saved = '[ground]\ndefault = "Rock"\n';
const set = (value: number) => edit('change Rocks', [{ set: ['rocks'], value }], 'rocks');

beforeEach(() => {
  messages.value = [];
  begin('a.toml', saved, saved, 'hash');
});

describe('a step', () => {
  test('is all that is typed into one field', () => {
    [1, 10, 100].forEach(set);
    undo();
    expect(text.value).toBe(saved);
    redo();
    expect(values.value.rocks).toBe(100);
  });
  test('ends where the field is left, and where the project is saved', () => {
    set(100);
    endStep();
    set(200);
    settle('a.toml', text.value, 'hash 2');
    set(300);
    const seen = [300, 200, 100].map((rocks) => {
      expect(values.value.rocks).toBe(rocks);
      undo();
      return rocks;
    });
    expect([seen.length, text.value]).toEqual([3, saved]);
  });
});

describe('a text that is not TOML', () => {
  const broken = `${saved}\n[[broken\n`;
  test('is not changed by forms, which say so once', () => {
    replaceText(broken, 'edit the text');
    expect([set(1), set(10)]).toEqual([false, false]);
    expect(text.value).toBe(broken);
    expect(undoes.value).toBe('edit the text');
    expect(messages.value.map(({ kind, text: said }) => `${kind}: ${said}`)).toEqual([
      'error: Could not change Rocks: the text is not TOML (line 5: Unterminated table-key). Correct it under Text first',
    ]);
  });
  test('says what it said last', () => {
    expect(values.value).toEqual({ ground: { default: 'Rock' } });
    replaceText(broken, 'edit the text');
    expect(values.value).toEqual({ ground: { default: 'Rock' } });
  });
  test('and nothing of the project that was open before', () => {
    expect(values.value).not.toEqual({});
    leave();
    begin('b.toml', broken, broken, 'hash');
    expect(values.value).toEqual({});
    begin('c.toml', broken, broken, 'hash');
    expect(values.value).toEqual({});
  });
});

test('an edit that the text does not allow is said', () => {
  expect(edit('draw seeder 1', [{ set: ['seeder', 0, 'position'], value: [0, 0] }])).toBe(false);
  expect(messages.value.map(({ text: said }) => said)).toEqual([
    'Could not draw seeder 1: there is no [[seeder]] number 0',
  ]);
});
