// Whether a setting has an effect in the project. Settings that are not given have their declared defaults.

import type { TomlTable } from '../toml/format';
import { schema } from '../generated/schema';
import { hasEffect, isMet, type Condition, type Needs } from './conditions';

interface Declared {
  default?: unknown;
  'x-default-by-laws'?: Record<string, unknown>;
}
type Properties = Record<string, Declared | undefined>;
interface Node {
  properties?: Properties;
  items?: { properties?: Properties };
}

function defaultOf(table: string, key: string, laws: unknown): unknown {
  const node = (schema.properties as Record<string, Node>)[table];
  const declared = (node?.properties ?? node?.items?.properties)?.[key];
  return declared?.['x-default-by-laws']?.[String(laws)] ?? declared?.default;
}

export const holds = (condition: Condition, table: string, row: TomlTable, project: TomlTable): boolean =>
  isMet(condition, table, row, project, defaultOf);

/// Conditions on the setting `except` count as met.
export const applies = (needs: Needs, table: string, row: TomlTable, project: TomlTable, except = ''): boolean =>
  hasEffect(needs, table, row, project, defaultOf, except);
