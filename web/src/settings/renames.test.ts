import { describe, expect, test } from 'vitest';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import { renaming, type FormerName } from './renames';

const text = `material = [{ name = "Rock" }, { name = "Scree" }, { name = "Soil" }]
area = [{ name = "Rock", material = "Scree" }, { material = "Rock" }]
barrier = [{ name = "Net" }, { height_m = 3 }]
collector = [{ name = "Road" }]
[ground]
default = "Rock"
segments = ["Rock", "Scree", "Soil"]
values = { Rock = "Scree" }
[design]
lines = ["Net", "Road", "barrier 2"]
protect = "Road"
`;

/// The project after renaming one entry after the other; an empty name: it is cleared.
function after(...renames: [string, number, string][]) {
  let now = text;
  let known: FormerName[] = [];
  for (const [table, index, name] of renames) {
    const path = [table, index, 'name'];
    const next = name === '' ? undefined : name;
    const more = renaming(valuesOf(now), path, next, known);
    now = edited(now, [next === undefined ? { remove: path } : { set: path, value: next }, ...more.edits]);
    known = more.known;
  }
  const { ground, area, design } = valuesOf(now) as Record<string, Record<string, unknown>>;
  const areas = (area as unknown as { material: string }[]).map(({ material }) => material);
  return { ...ground, areas, ...design };
}
const before = after();

describe('references to a renamed entry', () => {
  test('follow a material', () =>
    expect(after(['material', 0, 'Granite'])).toEqual({
      ...before,
      default: 'Granite',
      segments: ['Granite', 'Scree', 'Soil'],
      areas: ['Scree', 'Granite'],
    }));
  test('follow barriers and collectors', () =>
    expect(after(['collector', 0, 'Street'], ['barrier', 1, 'Wall'])).toEqual({
      ...before,
      lines: ['Net', 'Street', 'Wall'],
      protect: 'Street',
    }));
  test('use the default name while the entry has none', () => {
    expect(after(['barrier', 0, '']).lines).toEqual(['barrier 1', 'Road', 'barrier 2']);
    expect(after(['barrier', 0, ''], ['barrier', 0, 'Net'])).toEqual(before);
  });
  test('do not depend on names in other tables', () =>
    expect(renaming(valuesOf(text), ['seeder', 0, 'name'], 'Rock', [])).toEqual({ edits: [], known: [] }));
});

describe('two entries of the same name', () => {
  test('references to the first entry stay with it', () =>
    expect(after(['material', 1, 'Rock'])).toEqual(before));
  test('references follow when the second name is corrected', () =>
    expect(after(['material', 1, 'Rock'], ['material', 1, 'Rock 2'])).toEqual(after(['material', 1, 'Rock 2'])));
  test('references follow when the second name is cleared in between', () =>
    expect(after(['material', 1, 'Rock'], ['material', 1, ''], ['material', 1, 'Rock 2'])).toEqual(
      after(['material', 1, 'Rock 2']),
    ));
  test('references follow when the first entry is renamed', () =>
    expect(after(['material', 1, 'Rock'], ['material', 0, 'Granite']).segments).toEqual(['Granite', 'Rock', 'Soil']));
  test('the entries can exchange their names', () =>
    expect(after(['material', 1, 'Rock'], ['material', 0, 'Scree']).segments).toEqual(['Scree', 'Rock', 'Soil']));
  test('a name that still refers to another entry is not reused', () => {
    const renames: [string, number, string][] = [
      ['material', 1, 'Rock'],
      ['material', 2, 'Scree'],
    ];
    expect(after(...renames)).toEqual(before);
    expect(after(...renames, ['material', 1, 'Gravel']).segments).toEqual(['Rock', 'Gravel', 'Scree']);
  });
  test('barriers and collectors share their names', () =>
    expect(after(['barrier', 0, 'Road'], ['barrier', 0, 'Fence'])).toEqual({
      ...before,
      lines: ['Fence', 'Road', 'barrier 2'],
    }));
  test('references are ambiguous if the file had the same name twice', () => {
    const twice = valuesOf(text.replace('"Scree" }, {', '"Rock" }, {'));
    expect(renaming(twice, ['material', 1, 'name'], 'Rock 2', []).edits).toEqual([]);
  });
});
