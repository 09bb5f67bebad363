// The tables and settings of the project file for the forms, read from the schema.

import type { Condition } from './conditions';
import type { Name, TableName } from './names';
import { titleOf, unitText } from './titles';

export interface Range {
  least?: number;
  most?: number;
  leastExcluded?: boolean;
  mostExcluded?: boolean;
}

/// The kind of a value in the file.
export type Kind =
  | { kind: 'number' | 'whole'; range: Range }
  | { kind: 'boolean' | 'text' | 'file' }
  /// A file, or a list of files.
  | { kind: 'files' }
  | { kind: 'choice'; words: string[] }
  | { kind: 'distribution'; range: Range; parts: Field[] }
  /// One of several words, or a number.
  | { kind: 'word or number'; words: string[]; whole: boolean; range: Range }
  /// Several of these words, all of them (true) or none (false).
  | { kind: 'words'; words: string[] }
  | { kind: 'list'; of: 'number' | 'whole' | 'text' }
  /// A point or vector. Single numbers may be words, such as "surface"; `instead` are words for the whole tuple.
  | { kind: 'tuple'; least: number; most: number; words: string[]; instead: string[] }
  /// Rows of such tuples; or the name of a file that has them.
  | { kind: 'rows'; least: number; columns: number; whole: boolean; words: string[]; orFile: boolean }
  | { kind: 'lists of rows'; columns: number }
  /// x in 2D, points on plan in 3D.
  | { kind: 'line' }
  /// A table from values in a data file to names in the project.
  | { kind: 'names'; whole: boolean };

export interface Field {
  key: Name;
  title: string;
  unit: string;
  type: Kind;
  description: string;
  source: string;
  required: boolean;
  /// As in the file; undefined if there is none.
  default?: unknown;
  /// Defaults that other laws (`analysis.laws`) have.
  defaultByLaws: Readonly<Record<string, unknown>>;
  /// What applies if the key is absent and there is no default.
  withoutIt: string;
  /// Whether `inf` is allowed.
  infinite: boolean;
  excludes: Name[];
  /// It has an effect if at least one condition of each list is met.
  needs: Condition[][];
  /// The only rock model for which it has an effect; '': all.
  onlyFor: string;
  group: string;
  /// A section of the documentation.
  topic?: Topic;
}

export interface Topic {
  document: string;
  heading: string;
}

export interface Table {
  key: TableName | '';
  repeated: boolean;
  description: string;
  fields: Field[];
  /// Alternatives, each a list of keys. Keys of different alternatives exclude each other.
  choices: Name[][][];
  groups: { title: string; folded: boolean }[];
  topic?: Topic;
}

interface Node {
  type?: string;
  enum?: string[];
  const?: string;
  anyOf?: Node[];
  items?: Node;
  minItems?: number;
  maxItems?: number;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  properties?: Record<string, Node>;
  propertyNames?: { pattern?: string };
  required?: string[];
  description?: string;
  default?: unknown;
  'x-unit'?: string;
  'x-default-by-laws'?: Record<string, unknown>;
  'x-without-it'?: string;
  'x-source'?: string;
  'x-file'?: boolean;
  'x-infinite'?: boolean;
  'x-excludes'?: Name[];
  'x-applies-when'?: Condition[][];
  'x-title'?: string;
  'x-group'?: string;
  'x-topic'?: Topic;
  'x-choices'?: Name[][][];
  'x-groups'?: { title: string; folded: boolean }[];
}

const rangeOf = (node: Node): Range => ({
  least: node.minimum ?? node.exclusiveMinimum,
  most: node.maximum ?? node.exclusiveMaximum,
  leastExcluded: node.exclusiveMinimum !== undefined,
  mostExcluded: node.exclusiveMaximum !== undefined,
});

const rockModelKey = 'analysis.model';

const wordsOf = (node: Node): string[] => node.enum ?? (node.const !== undefined ? [node.const] : []);

const tupleOf = ({ items, minItems = 1, maxItems = 3 }: Node, instead: string[]): Kind => ({
  kind: 'tuple',
  least: minItems,
  most: maxItems,
  words: (items?.anyOf ?? []).flatMap(wordsOf),
  instead,
});

function alternatives(nodes: Node[]): Kind {
  const words = nodes.find(({ items }) => items?.enum)?.items?.enum;
  if (words && nodes.some(({ type }) => type === 'boolean')) return { kind: 'words', words };
  if (nodes.some((node) => node['x-file'])) {
    const rows = nodes.map(kindOf).find(({ kind }) => kind === 'rows');
    return rows?.kind === 'rows' ? { ...rows, orFile: true } : { kind: 'files' };
  }
  const number = nodes.find(({ type }) => type === 'number' || type === 'integer');
  const parts = nodes.find(({ properties }) => properties?.distribution);
  if (number && parts) return { kind: 'distribution', range: rangeOf(number), parts: fieldsOf(parts) };
  const tuple = nodes.find(({ type }) => type === 'array');
  if (number && tuple) return { kind: 'line' };
  if (tuple) return tupleOf(tuple, nodes.flatMap(wordsOf));
  return {
    kind: 'word or number',
    words: nodes.flatMap(wordsOf),
    whole: number?.type === 'integer',
    range: number ? rangeOf(number) : {},
  };
}

function arrayOf(node: Node): Kind {
  const item = node.items ?? {};
  if (item.type === 'array') {
    const inner = item.items ?? {};
    if (inner.type === 'array') return { kind: 'lists of rows', columns: inner.maxItems ?? 3 };
    return {
      kind: 'rows',
      least: item.minItems ?? 1,
      columns: item.maxItems ?? 3,
      whole: inner.type === 'integer',
      words: (inner.anyOf ?? []).flatMap(wordsOf),
      orFile: false,
    };
  }
  // An array that may be empty is a list, whatever its maximum length.
  if (node.minItems && node.maxItems !== undefined) return tupleOf(node, []);
  return { kind: 'list', of: item.type === 'string' ? 'text' : item.type === 'integer' ? 'whole' : 'number' };
}

function kindOf(node: Node): Kind {
  if (node.anyOf) return alternatives(node.anyOf);
  if (node.enum) return { kind: 'choice', words: node.enum };
  switch (node.type) {
    case 'number':
      return { kind: 'number', range: rangeOf(node) };
    case 'integer':
      return { kind: 'whole', range: rangeOf(node) };
    case 'boolean':
      return { kind: 'boolean' };
    case 'array':
      return arrayOf(node);
    case 'object':
      return { kind: 'names', whole: node.propertyNames?.pattern !== undefined };
    default:
      return { kind: node['x-file'] ? 'file' : 'text' };
  }
}

const onlyModel = (needs: readonly Condition[][]) =>
  needs.find((any) => any.length === 1 && any[0]!.key === rockModelKey)?.[0]?.is?.[0] ?? '';

/// What applies without a setting, with the titles of other settings of its table in place of their keys.
const withoutIt = (text: string, table: Node) =>
  text.replace(/`(\w+)`/g, (quoted, key: string) => {
    const node = table.properties?.[key];
    const title = node && (node['x-title'] ?? titleOf(key, node['x-unit']));
    return title ? title.charAt(0).toLowerCase() + title.slice(1) : quoted;
  });

function fieldsOf(table: Node): Field[] {
  return Object.entries(table.properties ?? {}).map(([key, node]) => ({
    key: key as Name,
    title: node['x-title'] ?? titleOf(key, node['x-unit']),
    unit: unitText(node['x-unit'] ?? ''),
    type: kindOf(node),
    description: node.description ?? '',
    source: node['x-source'] ?? '',
    required: table.required?.includes(key) ?? false,
    default: node.default,
    defaultByLaws: node['x-default-by-laws'] ?? {},
    withoutIt: withoutIt(node['x-without-it'] ?? '', table),
    infinite: node['x-infinite'] ?? false,
    excludes: node['x-excludes'] ?? [],
    needs: node['x-applies-when'] ?? [],
    onlyFor: onlyModel(node['x-applies-when'] ?? []),
    group: node['x-group'] ?? '',
    topic: node['x-topic'],
  }));
}

/// All tables of the project file; the one without a key has the settings before the first table.
export function tablesOf(schema: unknown): Table[] {
  const root = schema as Node;
  const isTable = (node: Node) => node.properties !== undefined || node.items?.properties !== undefined;
  const entries = Object.entries(root.properties ?? {});
  const before = Object.fromEntries(entries.filter(([, node]) => !isTable(node)));
  return [
    {
      key: '',
      repeated: false,
      description: root.description ?? '',
      fields: fieldsOf({ ...root, properties: before }),
      choices: [],
      groups: [],
    },
    ...entries
      .filter(([, node]) => isTable(node))
      .map(([key, node]) => {
        const table = node.items ?? node;
        return {
          key: key as TableName,
          repeated: node.items !== undefined,
          description: table.description ?? '',
          fields: fieldsOf(table),
          choices: table['x-choices'] ?? [],
          groups: table['x-groups'] ?? [],
          topic: table['x-topic'],
        };
      }),
  ];
}
