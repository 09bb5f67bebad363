// The settings of the project file, as the engine declares them; asked for once.

import { signal } from '@preact/signals';
import { api } from '../api/client';
import { sayFailure, settle } from '../state/messages';
import { tablesOf, type Field, type Table } from './schema';

export const tables = signal<Table[]>([]);

let asked = false;
export function loadSettings() {
  if (asked) return;
  asked = true;
  void api
    .settings()
    .then((schema) => {
      tables.value = tablesOf(schema);
      settle('settings');
    })
    .catch((error: unknown) => {
      asked = false;
      sayFailure(error, 'settings');
    });
}

export const tableOf = (key: string): Table | undefined => tables.value.find((table) => table.key === key);
export const fieldOf = (table: string, key: string): Field | undefined =>
  tableOf(table)?.fields.find((field) => field.key === key);
