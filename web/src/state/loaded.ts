// What the page loads for something that is shown, such as a run.

import { batch, effect, signal, type ReadonlySignal } from '@preact/signals';

export interface Loaded<T> {
  /// Null: not loaded.
  value: T | null;
  error: string | null;
}

export interface Wanted<T> {
  key: string;
  load: (signal: AbortSignal) => Promise<T>;
}

const nothing = { value: null, error: null };

/// Loads what is wanted whenever its key changes, and drops what was loaded for another one; null: nothing is wanted.
export function loadedFor<T>(wanted: () => Wanted<T> | null): ReadonlySignal<Loaded<T>> {
  const found = signal<Loaded<T>>(nothing);
  let [key, controller]: [string | null, AbortController | null] = [null, null];
  const take = async ({ load }: Wanted<T>, { signal: ends }: AbortController) => {
    let next: Loaded<T>;
    try {
      next = { value: await load(ends), error: null };
    } catch (error) {
      next = { value: null, error: error instanceof Error ? error.message : String(error) };
    }
    if (!ends.aborted) batch(() => (found.value = next));
  };
  effect(() => {
    const now = wanted();
    if ((now?.key ?? null) === key) return;
    key = now?.key ?? null;
    controller?.abort();
    found.value = nothing;
    if (now) void take(now, (controller = new AbortController()));
  });
  return found;
}
