// Tables of the settings that have an effect. Those that differ between two runs are shaded; those that differ from their
// defaults have these beside them.

import type { Group } from '../figures/plot';
import { element } from './figure';
import { settingText, unitOf, wordsOf } from './format';
import { runs, single, tableOf, type Run } from './run';
import { applies, defaultText } from './settingEffects';
import { table, type HeadCell, type Row } from './tables';

const groups = ['analysis', 'sampling', 'design', 'output'];
const shownElsewhere = ['report'];

function keysOf(run: Run, group: string): string[] {
  const settings = tableOf(run, group);
  return Object.keys(settings).filter((key) => applies(run, group, key, settings) && !shownElsewhere.includes(key));
}

const hasTable = ({ summary }: Run, group: string) => Boolean(summary.project[group]);
const valueOf = (run: Run, group: string, key: string) =>
  hasTable(run, group) ? settingText(tableOf(run, group)[key]) : '–';

function isChanged(group: string, key: string): boolean {
  const usual = defaultText(group, key);
  return usual !== null && runs.some((run) => hasTable(run, group) && valueOf(run, group, key) !== usual);
}

const differs = (group: string, key: string) => new Set(runs.map((run) => valueOf(run, group, key))).size > 1;

function settingsTable(parent: Group, group: string, keys: readonly string[]) {
  // A column with defaults, unless all settings have theirs.
  const hasDefaults = keys.some((key) => isChanged(group, key));
  const values: HeadCell[] = single ? [{ text: 'Value' }] : runs.map((run) => ({ text: run.label, run }));
  table(parent, {
    caption: wordsOf(group),
    head: [['Setting', ...values, ...(hasDefaults ? ['Default'] : [])]],
    rows: keys.map((key): Row => {
      const usual = isChanged(group, key) ? (defaultText(group, key) ?? '') : '';
      const name = { text: wordsOf(key), unit: unitOf(key) };
      return [name, ...runs.map((run) => valueOf(run, group, key)), ...(hasDefaults ? [usual] : [])];
    }),
    rowClass: (row) => (differs(group, keys[row]!) ? 'differs' : ''),
  });
}

export function settingsTables(parent: Group) {
  const shown = groups
    .map((group) => ({ group, keys: [...new Set(runs.flatMap((run) => keysOf(run, group)))] }))
    .filter(({ keys }) => keys.length > 0);
  if (shown.length === 0) {
    element(parent, 'p', 'The summary does not contain the project.', { class: 'quiet' });
    return;
  }
  for (const { group, keys } of shown) settingsTable(parent, group, keys);
  if (shown.some(({ group, keys }) => keys.some((key) => differs(group, key)))) {
    element(parent, 'p', 'Settings that differ are shaded.', { class: 'quiet' });
  }
}
