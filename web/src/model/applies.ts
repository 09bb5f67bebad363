// Whether a setting has an effect beside the other values of the project, by the conditions of its declaration.

import type { TomlTable, TomlValue } from '../toml/format';
import { schema } from '../generated/schema';
import { isTable } from './tables';

/// What another setting must say: of the same row, or of a table that there is one of ("terrain.raster").
export interface Condition {
  key: string;
  /// Whether the file has it.
  given?: boolean;
  /// Values as in the file, texts without quotes, of which it is one; or none.
  is?: readonly string[];
  not?: readonly string[];
}

type Properties = Record<string, { default?: unknown } | undefined>;
interface Node {
  properties?: Properties;
  items?: { properties?: Properties };
}

const propertiesOf = (table: string): Properties => {
  const node = (schema.properties as Record<string, Node>)[table];
  return node?.properties ?? node?.items?.properties ?? {};
};

const textOf = (value: unknown) => (Array.isArray(value) ? JSON.stringify(value) : String(value));

/// Of a condition of a setting of `table`, in the row, or in its table of the project.
export function holds({ key, given, is, not }: Condition, table: string, row: TomlTable, project: TomlTable): boolean {
  const [first, second] = key.split('.');
  const name = second === undefined ? table : first!;
  const own = second ?? first!;
  const other = project[name];
  const values = name === table ? row : isTable(other) ? other : {};
  const value: TomlValue | undefined = values[own];
  if (given !== undefined) return (value !== undefined) === given;
  const text = textOf(value ?? propertiesOf(name)[own]?.default);
  return is ? is.includes(text) : !not?.includes(text);
}

/// Whether all needs of a setting are met, but for those that are about another one.
export const applies = (
  needs: readonly (readonly Condition[])[],
  table: string,
  row: TomlTable,
  project: TomlTable,
  except = '',
): boolean =>
  needs.every((any) => any.some((one) => one.key === except) || any.some((one) => holds(one, table, row, project)));
