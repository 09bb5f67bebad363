import { describe, expect, test } from 'vitest';
import { edited, valuesOf } from '../toml/edit';
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

describe('who calls an entry by its name', () => {
  test('calls a material by its new one', () =>
    expect(after(['material', 0, 'Granite'])).toEqual({
      ...before,
      default: 'Granite',
      segments: ['Granite', 'Scree', 'Soil'],
      areas: ['Scree', 'Granite'],
    }));
  test('calls barriers and collectors by their new ones', () =>
    expect(after(['collector', 0, 'Street'], ['barrier', 1, 'Wall'])).toEqual({
      ...before,
      lines: ['Net', 'Street', 'Wall'],
      protect: 'Street',
    }));
  test('calls it by its number while it has none', () => {
    expect(after(['barrier', 0, '']).lines).toEqual(['barrier 1', 'Road', 'barrier 2']);
    expect(after(['barrier', 0, ''], ['barrier', 0, 'Net'])).toEqual(before);
  });
  test('other settings are nobody\'s name', () =>
    expect(renaming(valuesOf(text), ['seeder', 0, 'name'], 'Rock', [])).toEqual({ edits: [], known: [] }));
});

describe('two of one name', () => {
  test('one that takes the name of another does not take what is the other\'s', () =>
    expect(after(['material', 1, 'Rock'])).toEqual(before));
  test('and is called by the name that it is corrected to', () =>
    expect(after(['material', 1, 'Rock'], ['material', 1, 'Rock 2'])).toEqual(after(['material', 1, 'Rock 2'])));
  test('nor when it is cleared in between', () =>
    expect(after(['material', 1, 'Rock'], ['material', 1, ''], ['material', 1, 'Rock 2'])).toEqual(
      after(['material', 1, 'Rock 2']),
    ));
  test('when the other gives way, each is called by its own', () =>
    expect(after(['material', 1, 'Rock'], ['material', 0, 'Granite']).segments).toEqual(['Granite', 'Rock', 'Soil']));
  test('they exchange their names', () =>
    expect(after(['material', 1, 'Rock'], ['material', 0, 'Scree']).segments).toEqual(['Scree', 'Rock', 'Soil']));
  test('a name by which another is still called is not taken over', () => {
    const renames: [string, number, string][] = [
      ['material', 1, 'Rock'],
      ['material', 2, 'Scree'],
    ];
    expect(after(...renames)).toEqual(before);
    expect(after(...renames, ['material', 1, 'Gravel']).segments).toEqual(['Rock', 'Gravel', 'Scree']);
  });
  test('a barrier and a collector share their names', () =>
    expect(after(['barrier', 0, 'Road'], ['barrier', 0, 'Fence'])).toEqual({
      ...before,
      lines: ['Fence', 'Road', 'barrier 2'],
    }));
  test('of those that were so in the file, none is meant more than the other', () => {
    const twice = valuesOf(text.replace('"Scree" }, {', '"Rock" }, {'));
    expect(renaming(twice, ['material', 1, 'name'], 'Rock 2', []).edits).toEqual([]);
  });
});
