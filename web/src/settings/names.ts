// The names of tables and settings of the project file, as types from their declaration: a name that does not exist does
// not compile.

import { schema } from '../generated/schema';
import type { TomlValue } from '../toml/format';

type Root = typeof schema.properties;
type PropertiesOf<Node> = Node extends { items: { properties: infer Properties } }
  ? Properties
  : Node extends { properties: infer Properties }
    ? Properties
    : never;

export type TableName = { [T in keyof Root]: [PropertiesOf<Root[T]>] extends [never] ? never : T }[keyof Root];
/// The settings of a table, or of any of several tables.
export type KeyOf<T extends TableName = TableName> = T extends TableName ? keyof PropertiesOf<Root[T]> & string : never;

type Random = Root['material']['items']['properties']['normal_restitution']['anyOf'][1];
/// The parts of a random property.
export type PartName = keyof Random['properties'] & string;

/// The distribution of a property with the same value every time.
export const constantKind: Random['properties']['distribution']['enum'][number] = 'none';
/// The distribution of a property whose values are those of a file.
export const sampleKind: Random['properties']['distribution']['enum'][number] = 'empirical';

export type Name = TableName | KeyOf | PartName | Exclude<keyof Root, TableName>;
/// The path of a value in the project: `['seeder', 0, 'position']`.
export type Path = readonly (Name | number)[];

export type Edit = { set: Path; value: TomlValue } | { remove: Path } | { insert: Path; value: TomlValue } | { append: Path; value: Row; comment?: string };

/// The values of a table, or of an entry of a list.
export type Row<T extends TableName = TableName> = { [K in KeyOf<T>]?: TomlValue };

/// The words that a setting accepts.
export type WordOf<T extends TableName, K extends KeyOf<T>> =
  PropertiesOf<Root[T]> extends Record<K, { enum: readonly (infer Word extends string)[] }> ? Word : never;

type Declared<T extends TableName, K extends KeyOf<T>> = K extends keyof PropertiesOf<Root[T]>
  ? PropertiesOf<Root[T]>[K]
  : never;
type DefaultOf<T extends TableName, K extends KeyOf<T>> = Declared<T, K> extends { default: infer Value } ? Value : undefined;

/// The default of a setting.
export function defaultOf<T extends TableName, K extends KeyOf<T>>(table: T, key: K): DefaultOf<T, K> {
  const node = schema.properties[table] as { properties?: object; items?: { properties: object } };
  const properties = (node.properties ?? node.items?.properties ?? {}) as Record<string, { default?: unknown }>;
  return properties[key]?.default as DefaultOf<T, K>;
}

/// A name chosen by the user, such as a class of a raster, as a part of a path.
export const chosenName = (name: string) => name as Name;

/// Parses a path such as the engine's "material.0.name".
export const pathOf = (text: string): Path =>
  text.split('.').map((part) => (/^\d+$/.test(part) ? Number(part) : (part as Name)));
