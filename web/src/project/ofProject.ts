// Signals that belong to the open project. They are reset when another project is opened.

import { effect, signal, untracked, type Signal } from '@preact/signals';
import { storageKey } from '../state/about';
import { file, opening } from './document';

/// A signal that is reset whenever a project is opened or closed.
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
    // The browser's storage is full; the value is lost when the page is closed.
  }
}

/// A signal whose value the browser stores for each project.
export function keptOfProject<T extends string | number | boolean>(what: string, first: T): Signal<T> {
  const value = signal<T>(first);
  let of = opening.peek();
  effect(() => {
    const [name, now] = [file.value, value.value];
    // The value of the previous project must not be stored for the next one.
    if (of !== opening.value) {
      of = opening.value;
      untracked(() => (value.value = name === null ? first : read(storageKey(`view ${what}`, name), first)));
    } else if (name !== null) write(storageKey(`view ${what}`, name), now, first);
  });
  return value;
}
