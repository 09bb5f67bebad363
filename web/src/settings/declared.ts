// The declared settings of the project file.

import { schema } from '../generated/schema';
import { tablesOf, type Field, type Table } from './schema';

export const tables: readonly Table[] = tablesOf(schema);

export const tableOf = (key: string): Table | undefined => tables.find((table) => table.key === key);
export const fieldOf = (table: string, key: string): Field | undefined =>
  tableOf(table)?.fields.find((field) => field.key === key);
