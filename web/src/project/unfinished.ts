// Incomplete rows of the forms, which are not part of the project. The browser stores them until they are completed or
// discarded.

import { effect, signal } from '@preact/signals';
import { storageKey } from '../state/about';
import { file, values } from './document';
import type { TomlTable } from '../toml/format';
import { following, stillOpen, type Unfinished } from '../settings/following';
import { isBlank, type Waiting } from '../settings/waitingRows';

export const unfinished = signal<Unfinished>({});

const none: readonly Waiting[] = [];
export const waitingAt = (path: string) => unfinished.value[path] ?? none;

export function keepWaiting(path: string, rows: readonly Waiting[]) {
  const { [path]: before, ...others } = unfinished.peek();
  if (rows.length > 0) unfinished.value = { ...others, [path]: rows };
  else if (before) unfinished.value = others;
}

/// Whether something is typed in any of the rows.
export const hasTyped = (rows: readonly Waiting[]) => rows.some(({ cells }) => !isBlank(cells));

const keyOf = (name: string) => storageKey('incomplete rows', name);

function store(name: string, rows: Unfinished) {
  if (!Object.values(rows).some(hasTyped)) return localStorage.removeItem(keyOf(name));
  try {
    localStorage.setItem(keyOf(name), JSON.stringify(rows));
  } catch {
    // The browser's storage is full; the rows are lost when the page is closed.
  }
}
const stored = (name: string) => JSON.parse(localStorage.getItem(keyOf(name)) ?? '{}') as Unfinished;

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
    // The same project under another name.
    store(before.name, {});
    store(now.name, rows);
  } else unfinished.value = now.name === null ? {} : stillOpen(stored(now.name), now.values);
});

effect(() => {
  const rows = unfinished.value;
  if (file.peek() !== null) store(file.peek()!, rows);
});
