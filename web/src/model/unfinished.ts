// What is typed into rows of the forms but not complete, and so no part of the project: kept by the browser until it is
// complete or taken back.

import { effect, signal } from '@preact/signals';
import { keptKey } from '../state/about';
import { file, values } from '../state/document';
import type { TomlTable } from '../toml/format';
import { following, stillOpen, type Unfinished } from './following';
import { isBlank, type Waiting } from './waitingRows';

export const unfinished = signal<Unfinished>({});

const none: readonly Waiting[] = [];
export const waitingAt = (path: string) => unfinished.value[path] ?? none;

export function wait(path: string, rows: readonly Waiting[]) {
  const { [path]: before, ...others } = unfinished.peek();
  if (rows.length > 0) unfinished.value = { ...others, [path]: rows };
  else if (before) unfinished.value = others;
}

/// Those in which something is typed.
export const hasTyped = (rows: readonly Waiting[]) => rows.some(({ cells }) => !isBlank(cells));

const keyOf = (name: string) => keptKey('unfinished rows', name);

function keep(name: string, rows: Unfinished) {
  if (!Object.values(rows).some(hasTyped)) return localStorage.removeItem(keyOf(name));
  try {
    localStorage.setItem(keyOf(name), JSON.stringify(rows));
  } catch {
    // The browser has no more room; they stay as long as the page.
  }
}
const keptOf = (name: string) => JSON.parse(localStorage.getItem(keyOf(name)) ?? '{}') as Unfinished;

let known: { name: string | null; values: TomlTable } = { name: null, values: {} };
effect(() => {
  const now = { name: file.value, values: values.value };
  const [before, rows] = [known, unfinished.peek()];
  known = now;
  if (now.name === before.name) {
    if (Object.keys(rows).length > 0) {
      unfinished.value = stillOpen(following(rows, before.values, now.values), now.values);
    }
  } else if (now.name !== null && before.name !== null && now.values === before.values) {
    // The same project by another name.
    keep(before.name, {});
    keep(now.name, rows);
  } else unfinished.value = now.name === null ? {} : stillOpen(keptOf(now.name), now.values);
});

effect(() => {
  const rows = unfinished.value;
  if (file.peek() !== null) keep(file.peek()!, rows);
});
