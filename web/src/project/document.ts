// The open project: its text, and the steps for Undo. The text is the only source; forms and views are derived from it,
// and every change is a change of the text.

import { batch, computed, effect, signal } from '@preact/signals';
import type { Edit, Path, Row, TableName } from '../settings/names';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import type { TomlTable, TomlValue } from '../toml/format';
import { notify, resolve, resolveAll } from '../state/messages';
import { owned } from '../state/owned';

/// A change beside the text, such as that of a drawn line, with the functions that undo and redo it.
interface Beside {
  back: () => void;
  forth: () => void;
}
interface Step {
  text: string;
  what: string; // for "Undo: ..."
  beside?: Beside | undefined;
}

const mostSteps = 500;
const mostCharacters = 50_000_000; // of all steps together

/// The file's name, relative to the folder; null if no project is open.
export const file = signal<string | null>(null);
/// Incremented whenever a project is opened or closed, so that tasks of one do not continue in the next.
export const opening = signal(0);
/// The file's name without folder and extension, used for projects without a name.
export const fileStem = () => (file.value ?? '').replace(/^.*\/|\.toml$/g, '');
export const text = signal('');
/// The hash of the file that the text is based on or was last saved to; null if it was never saved.
export const [savedHash, setSavedHash] = owned(signal<string | null>(null));
const savedText = signal('');
const past = signal<Step[]>([]);
const future = signal<Step[]>([]);

export const isChanged = computed(() => text.value !== savedText.value || savedHash.value === null);
export const undoes = computed(() => past.value.at(-1)?.what ?? null);
export const redoes = computed(() => future.value.at(-1)?.what ?? null);
/// How the restored draft relates to the file, until the user dismisses the notice; null if there is none.
export const [restored, noteRestored] = owned(signal<'of the file' | 'of an earlier file' | 'of a deleted file' | null>(null));

/// The values of the text; while it is not valid TOML, the last valid ones.
let last: { opening: number; values: TomlTable } = { opening: 0, values: {} };
export const syntaxError = signal<{ line: number; message: string } | null>(null);
export const values = computed<TomlTable>(() => {
  if (last.opening !== opening.value) last = { opening: opening.value, values: {} };
  try {
    last.values = valuesOf(text.value);
  } catch {
    // Reported by `syntaxError` and by the server, with the line.
  }
  return last.values;
});
effect(() => {
  try {
    valuesOf(text.value);
    syntaxError.value = null;
    resolve('edit'); // edits are possible again
  } catch (error) {
    const { lineNumber, message } = error as { lineNumber?: number; message: string };
    syntaxError.value = { line: lineNumber ?? 0, message };
  }
});

/// The value at a path of the project; undefined if not given.
export function valueAt(path: Path): TomlValue | undefined {
  return path.reduce<TomlValue | undefined>(
    (at, part) => (at !== null && typeof at === 'object' ? (at as Record<string, TomlValue>)[String(part)] : undefined),
    values.value,
  );
}

/// The entries of a repeated table: `rowsOf('material')`.
export function rowsOf<T extends TableName>(key: T): Row<T>[] {
  const rows = values.value[key];
  return Array.isArray(rows) ? (rows as Row<T>[]) : [];
}

function remember(step: Step) {
  const steps = [...past.value, step].slice(-mostSteps);
  let characters = steps.reduce((sum, { text: part }) => sum + part.length, 0);
  while (steps.length > 1 && characters > mostCharacters) characters -= steps.shift()!.text.length;
  past.value = steps;
}

/// Sets a new text as one step. Consecutive steps with the same `merge`, such as keystrokes in one field, are undone
/// together.
export function replaceText(next: string, what: string, merge = '') {
  if (next === text.value) return;
  batch(() => {
    if (!merge || merge !== lastMerge) remember({ text: text.value, what });
    future.value = [];
    text.value = next;
  });
  lastMerge = merge;
}
/// Records a change beside the text, which was already made, as a step.
export function recordBeside(what: string, back: () => void, forth: () => void) {
  batch(() => {
    remember({ text: text.value, what, beside: { back, forth } });
    future.value = [];
  });
  endStep();
}
let lastMerge = '';
/// Ends merging: a field was left, or the project was saved or computed.
export function endStep() {
  lastMerge = '';
}

/// Applies edits to the text as one step. Returns false and reports an error if that is not possible.
export function edit(what: string, edits: readonly Edit[], merge = ''): boolean {
  try {
    replaceText(edited(text.value, edits), what, merge);
    resolve('edit');
    return true;
  } catch (error) {
    const invalid = syntaxError.value;
    const why = invalid
      ? `the text is not valid TOML (line ${invalid.line}: ${invalid.message}). Correct it in the Text tab first`
      : (error as Error).message;
    notify('error', `Could not ${what}: ${why}`, 'edit');
    return false;
  }
}

export function undo() {
  const step = past.value.at(-1);
  if (!step) return;
  batch(() => {
    future.value = [...future.value, { ...step, text: text.value }];
    past.value = past.value.slice(0, -1);
    text.value = step.text;
    step.beside?.back();
  });
  endStep();
}

export function redo() {
  const step = future.value.at(-1);
  if (!step) return;
  batch(() => {
    past.value = [...past.value, { ...step, text: text.value }];
    future.value = future.value.slice(0, -1);
    text.value = step.text;
    step.beside?.forth();
  });
  endStep();
}

/// Opens a project: its current text, the saved text, and the hash of the file.
export function begin(name: string, now: string, saved: string, hash: string | null) {
  resolveAll();
  batch(() => {
    ++opening.value;
    file.value = name;
    past.value = [];
    future.value = [];
    savedText.value = saved;
    setSavedHash(hash);
    noteRestored(null);
    text.value = now;
  });
  endStep();
}

export function leave() {
  resolveAll();
  batch(() => {
    ++opening.value;
    file.value = null;
  });
}

/// Records that the file `name` has this text and hash.
export function markSaved(name: string, saved: string, hash: string | null) {
  batch(() => {
    file.value = name;
    setSavedHash(hash);
    savedText.value = saved;
    noteRestored(null);
  });
  endStep();
}
