// Signals stored in the browser, independent of the project.

import { effect, signal } from '@preact/signals';

export function kept<T>(key: string, first: T) {
  const found = localStorage.getItem(key);
  const value = signal<T>(found === null ? first : (JSON.parse(found) as T));
  effect(() => localStorage.setItem(key, JSON.stringify(value.value)));
  return value;
}
