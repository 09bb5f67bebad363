// The groups of a table's form, and which of its fields apply given the other values.

import type { TomlTable } from '../toml/format';
import { applies } from './applies';
import type { Field, Table } from './schema';

export interface Group {
  title: string;
  /// Initially closed, unless one of its settings is given.
  folded: boolean;
  fields: Field[];
}

/// Tables with a form of their own for the first choice. Its settings appear as fields once they are given.
const chosenElsewhere = ['terrain', 'ground'];

/// The groups of the table; the first has no title and contains the settings without a group. (The declaration lists it
/// if it is of several groups.)
export function groupsIn(table: Table, fields: readonly Field[]): Group[] {
  const groups = [{ title: '', folded: false }, ...table.groups.filter(({ title }) => title !== '')];
  return groups.map((group) => ({ ...group, fields: fields.filter((field) => field.group === group.title) }));
}

/// Whether a setting applies, given the others. Settings of the other rock model are offered and marked at their field.
export function isOffered(table: Table, { key, needs }: Field, row: TomlTable, project: TomlTable): boolean {
  const isOfWay = chosenElsewhere.includes(table.key) && (table.choices[0]?.flat().includes(key) ?? false);
  return !isOfWay && applies(needs, table.key, row, project, 'analysis.model');
}

/// The choices among the shown fields: for each way its shown fields.
export const choicesOf = ({ choices }: Table, shown: readonly Field[]): Field[][][] =>
  choices
    .map((ways) =>
      ways
        .map((keys) => keys.flatMap((key) => shown.find((field) => field.key === key) ?? []))
        .filter((way) => way.length > 0),
    )
    .filter((ways) => ways.length > 1);
