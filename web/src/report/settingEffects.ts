// Which settings have an effect, and their defaults.

import type { Setting, Settings } from '../archive/summary';
import { settingConditions, settingDefaults } from '../generated/reportSettings';
import { hasEffect, type Needs } from '../settings/conditions';
import { settingText } from './format';
import type { Run } from './run';

const conditions: Record<string, Record<string, Needs>> = settingConditions;
const defaults: Record<string, Record<string, Setting>> = settingDefaults;

export const applies = (run: Run, table: string, key: string, row: Settings) =>
  hasEffect(conditions[table]?.[key] ?? [], table, row, run.summary.project);

/// A setting's default, if it has a fixed one; null: it has none.
export function defaultText(table: string, key: string): string | null {
  const value = defaults[table]?.[key];
  return value === undefined ? null : settingText(value);
}
