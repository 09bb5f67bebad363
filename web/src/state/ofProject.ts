// How a project is looked at. It belongs to the project: another one that is opened begins with nothing of it.

import { effect, signal, untracked, type Signal } from '@preact/signals';
import { keptKey } from './about';
import { file, opening } from './document';

/// A signal that begins anew whenever a project is opened or left.
export function ofProject<T>(first: T): Signal<T> {
  const value = signal<T>(first);
  effect(() => {
    void opening.value;
    value.value = first;
  });
  return value;
}

function read<T>(key: string, first: T): T {
  const found = localStorage.getItem(key);
  if (found === null) return first;
  try {
    return JSON.parse(found) as T;
  } catch {
    return first;
  }
}

function write<T>(key: string, value: T, first: T) {
  if (value === first) return localStorage.removeItem(key);
  try {
    localStorage.setItem(key, JSON.stringify(value));
  } catch {
    // The browser has no more room: it holds until the page is closed.
  }
}

/// The same, of which the browser remembers, project by project, what is not as at first.
export function keptOfProject<T extends string | number | boolean>(what: string, first: T): Signal<T> {
  const value = signal<T>(first);
  let of = opening.peek();
  effect(() => {
    const [name, now] = [file.value, value.value];
    // What was of the project before is not written under the name of the next.
    if (of !== opening.value) {
      of = opening.value;
      untracked(() => (value.value = name === null ? first : read(keptKey(`view ${what}`, name), first)));
    } else if (name !== null) write(keptKey(`view ${what}`, name), now, first);
  });
  return value;
}
