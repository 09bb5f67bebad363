// Tables of one run or two: one for both where they agree.

import { unitOf, wordsOf } from './format';
import { runs, single } from './run';
import { table } from './tables';

// One table for both runs if they agree, otherwise one for each.
export function forEachRun(caption, listOfRun, show) {
  const lists = runs.map(listOfRun);
  const same = !single && JSON.stringify(lists[0]) === JSON.stringify(lists[1]);
  runs.forEach((run, i) => {
    if ((same && i > 0) || !lists[i].length) return;
    show(single || same ? caption : `${caption} · ${run.label}`, lists[i]);
  });
}

// Items with settings, {name, key: value, ...}: one row each if the settings are few, otherwise one column each, with as
// many columns per table as fit on paper.
export function listTable(parent, caption, listOfRun, textOf) {
  const mostKeysInARow = 5, mostColumns = 5;
  const isGiven = (value) => value !== null && value !== undefined;
  forEachRun(caption, listOfRun, (title, list) => {
    const keys = [...new Set(list.flatMap(Object.keys))].filter((key) => key !== 'name' && list.some((item) => isGiven(item[key])));
    const cell = (item, key) => isGiven(item[key]) ? textOf(key, item[key]) : '–';
    if (keys.length <= mostKeysInARow) {
      table(parent, {
        caption: title,
        head: [['name', ...keys].map((key) => ({text: wordsOf(key), unit: unitOf(key)}))],
        rows: list.map((item) => [item.name, ...keys.map((key) => cell(item, key))]),
      });
      return;
    }
    const columns = Math.ceil(list.length / Math.ceil(list.length / mostColumns));
    for (let from = 0; from < list.length; from += columns) {
      const shown = list.slice(from, from + columns);
      table(parent, {
        caption: from === 0 ? title : `${title}, continued`,
        head: [['', ...shown.map((item) => item.name)]],
        rows: keys.filter((key) => shown.some((item) => isGiven(item[key])))
          .map((key) => [{text: wordsOf(key), unit: unitOf(key)}, ...shown.map((item) => cell(item, key))]),
      });
    }
  });
}

// A table of [label, value] rows, `rowsOf(run)`; one for each run where they differ.
export function factsTable(parent, caption, rowsOf) {
  forEachRun(caption, rowsOf, (title, rows) => table(parent, {caption: title, head: [], rows}));
}
