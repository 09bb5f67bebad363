// Who is called by a name when entries are renamed. One that takes the name of another is still called by its former
// name until its own is unique: whoever calls the other by it goes on to mean the other.

import { chosenName, type Edit, type Path, type TableName } from './names';
import type { TomlTable, TomlValue } from '../toml/format';
import { isTable, valueIn } from './tables';

/// An entry that is called by its former name.
export interface FormerName {
  key: TableName;
  index: number;
  name: string;
  former: string;
}

interface Entry extends FormerName {
  next: string;
}

/// Lists whose entries may not share names, and where entries are called by them.
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

/// What is below a path, and the names that stand there.
function namesAt(value: TomlValue | undefined, path: Path): { path: Path; name: string }[] {
  if (typeof value === 'string') return [{ path, name: value }];
  if (Array.isArray(value)) return value.flatMap((part, k) => namesAt(part, [...path, k]));
  return isTable(value) ? Object.entries(value).flatMap(([key, part]) => namesAt(part, [...path, chosenName(key)])) : [];
}

const nameOr = (name: TomlValue | undefined, key: string, index: number) =>
  typeof name === 'string' && name !== '' ? name : `${key} ${index + 1}`;

const othersThan = (own: Entry, entries: readonly Entry[]) => entries.filter((entry) => entry !== own);

/// What is known of former names may be of another text than this one, which was undone or typed over: it counts where
/// the name is shared and the former one is nobody's.
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

/// Those that are called by their next names from now on: which nobody else has, or is called by and stays so.
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

/// The edits that belong to setting the name at a path (undefined: to removing it), and who is called by a former name
/// afterwards.
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
  // What undoing brings back is known, too.
  return { edits, known: [...staying.map(({ next: name, ...entry }) => ({ ...entry, name })), ...known] };
}
