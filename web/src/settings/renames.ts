// Updates references when entries are renamed. While an entry has the same name as another, references to it keep its
// former name, so that references to the other one stay correct. They are updated once its name is unique.

import { chosenName, type Edit, type Path, type TableName } from './names';
import type { TomlTable, TomlValue } from '../toml/format';
import { isTable, valueIn } from './tables';

/// An entry whose references still have its former name.
export interface FormerName {
  key: TableName;
  index: number;
  name: string;
  former: string;
}

interface Entry extends FormerName {
  next: string;
}

/// Lists whose entries must have different names, and the settings that refer to them.
const families: { keys: TableName[]; places: Path[] }[] = [
  {
    keys: ['material'],
    places: [
      ['ground', 'default'],
      ['ground', 'segments'],
      ['ground', 'classes'],
      ['ground', 'values'],
    ],
  },
  {
    keys: ['barrier', 'collector'],
    places: [
      ['design', 'lines'],
      ['design', 'protect'],
    ],
  },
];

function placesIn(values: TomlTable, { keys, places }: (typeof families)[number]): Path[] {
  const areas = keys.includes('material') && Array.isArray(values.area) ? values.area : [];
  return [...places, ...areas.map((_, k) => ['area', k, 'material'] as const)];
}

/// The names at or below a path.
function namesAt(value: TomlValue | undefined, path: Path): { path: Path; name: string }[] {
  if (typeof value === 'string') return [{ path, name: value }];
  if (Array.isArray(value)) return value.flatMap((part, k) => namesAt(part, [...path, k]));
  return isTable(value) ? Object.entries(value).flatMap(([key, part]) => namesAt(part, [...path, chosenName(key)])) : [];
}

const nameOr = (name: TomlValue | undefined, key: string, index: number) =>
  typeof name === 'string' && name !== '' ? name : `${key} ${index + 1}`;

const othersThan = (own: Entry, entries: readonly Entry[]) => entries.filter((entry) => entry !== own);

/// The entries with their former names. `known` may be outdated by Undo or edits of the text: a former name counts only
/// if the name is shared and nobody else has the former one.
function entriesOf(values: TomlTable, keys: readonly TableName[], known: readonly FormerName[]): Entry[] {
  const entries = keys.flatMap((key) => {
    const rows = values[key];
    return (Array.isArray(rows) ? rows : []).map((row, index) => {
      const name = nameOr(isTable(row) ? row.name : undefined, key, index);
      const found = known.find((one) => one.key === key && one.index === index && one.name === name);
      return { key, index, name, former: found?.former ?? name, next: name };
    });
  });
  const isOutdated = (entry: Entry) => {
    const others = othersThan(entry, entries);
    const isShared = others.some(({ name, former }) => name === entry.name || former === entry.name);
    return entry.former !== entry.name && (!isShared || others.some(({ former }) => former === entry.former));
  };
  for (let found; (found = entries.find(isOutdated)); ) found.former = found.name;
  return entries;
}

/// The entries whose references get their next names: those whose next name is not in use by another entry.
function renamed(entries: readonly Entry[]): Entry[] {
  const going = new Set(entries.filter(({ former, next }) => former !== next));
  const stays = (entry: Entry) =>
    othersThan(entry, entries).some(
      (other) =>
        other.next === entry.next ||
        other.former === entry.former ||
        (other.former === entry.next && !going.has(other)),
    );
  for (let found; (found = [...going].find(stays)); ) going.delete(found);
  return [...going];
}

/// The edits of references when the name at a path is set (undefined: removed), and the entries that are then referred to
/// by a former name.
export function renaming(
  values: TomlTable,
  [table, index]: Path,
  next: TomlValue | undefined,
  known: readonly FormerName[],
): { edits: Edit[]; known: FormerName[] } {
  const family = families.find(({ keys }) => keys.some((key) => key === table));
  if (!family || typeof index !== 'number') return { edits: [], known: [...known] };
  const entries = entriesOf(values, family.keys, known).map((entry) =>
    entry.key === table && entry.index === index ? { ...entry, next: nameOr(next, entry.key, index) } : entry,
  );
  const going = renamed(entries);
  const edits = placesIn(values, family)
    .flatMap((place) => namesAt(valueIn(values, place), place))
    .flatMap(({ path, name }) => {
      const entry = going.find(({ former }) => former === name);
      return entry ? [{ set: path, value: entry.next }] : [];
    });
  const staying = entries.filter((entry) => entry.former !== entry.next && !going.includes(entry));
  // Earlier former names stay known, because Undo can bring them back.
  return { edits, known: [...staying.map(({ next: name, ...entry }) => ({ ...entry, name })), ...known] };
}
