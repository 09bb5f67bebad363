// The fields of a table's form in groups, and those of them that mean something beside the other values.

import type { TomlTable } from '../toml/format';
import { applies } from './applies';
import type { Field, Table } from './schema';

export interface Group {
  title: string;
  /// Until it is opened, or something in it is given.
  folded: boolean;
  fields: Field[];
}

/// Tables of which a form of their own chooses between the ways of the first choice: a way's keys stand in the table's
/// fields once they are given.
const chosenElsewhere = ['terrain', 'ground'];

/// A group for each of the table's; what stands in none is the first, without a title.
export function groupsIn(table: Table, fields: readonly Field[]): Group[] {
  const groups = [{ title: '', folded: false }, ...table.groups];
  return groups.map((group) => ({ ...group, fields: fields.filter((field) => field.group === group.title) }));
}

/// Whether a setting means anything beside the others. A rock model that it is not for is said at its field.
export function isOffered(table: Table, { key, needs }: Field, row: TomlTable, project: TomlTable): boolean {
  const isOfWay = chosenElsewhere.includes(table.key) && (table.choices[0]?.flat().includes(key) ?? false);
  return !isOfWay && applies(needs, table.key, row, project, 'analysis.model');
}

/// The fields that are shown, where there is a choice between them: of each way those that are shown.
export const choicesOf = ({ choices }: Table, shown: readonly Field[]): Field[][][] =>
  choices
    .map((ways) =>
      ways
        .map((keys) => keys.flatMap((key) => shown.find((field) => field.key === key) ?? []))
        .filter((way) => way.length > 0),
    )
    .filter((ways) => ways.length > 1);
