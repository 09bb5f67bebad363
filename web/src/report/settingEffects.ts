// Which settings have an effect, and their defaults.

import * as figures from '../figures/report';
import { settingText } from './format';
import { settingConditions, settingDefaults } from '../generated/reportSettings';

export const applies = (run, table, key, row) =>
  figures.hasEffect((settingConditions[table] || {})[key] || [], table, row, run.project);

// A setting's default, if it has a fixed one; `key` is "table/key".
export function defaultText(key) {
  const [group, name] = key.split('/');
  const value = (settingDefaults[group] || {})[name];
  return value === undefined ? null : settingText(value);
}
