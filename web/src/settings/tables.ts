// Access to values of the project.

import type { Path } from './names';
import type { TomlTable, TomlValue } from '../toml/format';

export const isTable = (value: unknown): value is TomlTable =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

export const valueIn = (values: TomlTable, path: Path) =>
  path.reduce<TomlValue | undefined>(
    (at, part) => (isTable(at) ? at[String(part)] : Array.isArray(at) ? at[Number(part)] : undefined),
    values,
  );
