// The Python package writes projects in the same layout (python/talus/toml_text.py); its test compares the same files.

import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { type Edit, edited } from './edit';
import type { TomlTable, TomlValue } from './format';

const folder = new URL('../../../python/tests/', import.meta.url);
const read = (name: string) => readFileSync(new URL(name, folder), 'utf8');

test('a project that is built key by key', () => {
  const settings = JSON.parse(read('written.json')) as TomlTable;
  const edits = Object.entries(settings).flatMap(([key, value]): Edit[] => {
    if (typeof value !== 'object') return [{ set: [key], value }];
    if (Array.isArray(value)) return value.map((row): Edit => ({ append: [key], value: row as TomlTable }));
    return Object.entries(value).map(([name, part]): Edit => ({ set: [key, name], value: part as TomlValue }));
  });
  expect(edited('', edits)).toBe(read('written.toml'));
});
