// Tables of one run or two: one for both where they agree.

import type { Setting, Settings } from '../archive/summary';
import type { Group } from '../figures/plot';
import { unitOf, wordsOf } from './format';
import { nameIn, runs, single, type Run } from './run';
import { table, type Row } from './tables';

/// One table for both runs if they agree, otherwise one for each; none without entries.
export function forEachRun<Entry>(
  caption: string,
  listOfRun: (run: Run) => readonly Entry[],
  show: (title: string, list: readonly Entry[]) => void,
) {
  const lists = runs.map(listOfRun);
  const same = !single && JSON.stringify(lists[0]) === JSON.stringify(lists[1]);
  lists.forEach((list, k) => {
    if ((same && k > 0) || list.length === 0) return;
    show(single || same ? caption : `${caption} · ${runs[k]!.label}`, list);
  });
}

const isGiven = (value: Setting) => value !== null && value !== undefined;
const [mostKeysInARow, mostColumns] = [5, 5];

/// Items with a name and settings: one row each if the settings are few, otherwise one column each, with as many columns
/// per table as fit on paper.
export function listTable(
  parent: Group,
  caption: string,
  listOfRun: (run: Run) => readonly Settings[],
  textOf: (key: string, value: Setting) => string,
) {
  forEachRun(caption, listOfRun, (title, list) => {
    const keys = [...new Set(list.flatMap(Object.keys))].filter(
      (key) => key !== 'name' && list.some((item) => isGiven(item[key])),
    );
    const cell = (item: Settings, key: string) => (isGiven(item[key]) ? textOf(key, item[key]) : '–');
    const heading = (key: string) => ({ text: wordsOf(key), unit: unitOf(key) });
    if (keys.length <= mostKeysInARow) {
      table(parent, {
        caption: title,
        head: [['name', ...keys].map(heading)],
        rows: list.map((item) => [nameIn(item), ...keys.map((key) => cell(item, key))]),
      });
      return;
    }
    const columns = Math.ceil(list.length / Math.ceil(list.length / mostColumns));
    for (let from = 0; from < list.length; from += columns) {
      const shown = list.slice(from, from + columns);
      table(parent, {
        caption: from === 0 ? title : `${title}, continued`,
        head: [['', ...shown.map(nameIn)]],
        rows: keys
          .filter((key) => shown.some((item) => isGiven(item[key])))
          .map((key) => [heading(key), ...shown.map((item) => cell(item, key))]),
      });
    }
  });
}

/// A table of rows with a label and a value; one for each run where they differ.
export function factsTable(parent: Group, caption: string, rowsOf: (run: Run) => readonly Row[]) {
  forEachRun(caption, rowsOf, (title, rows) => table(parent, { caption: title, head: [], rows }));
}
