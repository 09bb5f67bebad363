// The project that is open: its text, and every step that led to it. The text is the truth; forms and pictures follow
// from it, and a change is a change of the text.

import { batch, computed, effect, signal } from '@preact/signals';
import type { Edit, Path, Row, TableName } from "../model/names";
import { edited, valuesOf } from '../toml/edit';
import type { TomlTable, TomlValue } from '../toml/format';
import { say, settle as settleMessages, settleAll } from './messages';

interface Step {
  text: string;
  what: string; // for "Undo: ..."
}

const mostSteps = 500;
const mostCharacters = 50_000_000; // of all steps together

/// The file's name, relative to the folder; null: nothing is open.
export const file = signal<string | null>(null);
/// Another number for each project that is opened, and for none: what began in one does not go on in the next.
export const opening = signal(0);
/// Its name without folders and ending: what a project without a name is called.
export const fileStem = () => (file.value ?? '').replace(/^.*\/|\.toml$/g, '');
export const text = signal('');
/// The hash of the file that the text began from, or was written to last; null: it was never saved.
export const savedHash = signal<string | null>(null);
const savedText = signal('');
const past = signal<Step[]>([]);
const future = signal<Step[]>([]);

export const isChanged = computed(() => text.value !== savedText.value || savedHash.value === null);
export const undoes = computed(() => past.value.at(-1)?.what ?? null);
export const redoes = computed(() => future.value.at(-1)?.what ?? null);
/// A draft that was taken up, or the file of which changed while it was made, until the user has seen it.
export const takenUp = signal<'of the file' | 'of an earlier file' | 'of a file that is gone' | null>(null);

/// What the text says; while it is not TOML (in the text editor), what it said last.
let last: { opening: number; values: TomlTable } = { opening: 0, values: {} };
export const syntaxError = signal<{ line: number; message: string } | null>(null);
export const values = computed<TomlTable>(() => {
  if (last.opening !== opening.value) last = { opening: opening.value, values: {} };
  try {
    last.values = valuesOf(text.value);
  } catch {
    // Said by `syntaxError`, and by the server, with the line.
  }
  return last.values;
});
effect(() => {
  try {
    valuesOf(text.value);
    syntaxError.value = null;
    settleMessages('edit'); // could not be done to a text that was not TOML
  } catch (error) {
    const { lineNumber, message } = error as { lineNumber?: number; message: string };
    syntaxError.value = { line: lineNumber ?? 0, message };
  }
});

/// The value at a path of the project; undefined: not given.
export function valueAt(path: Path): TomlValue | undefined {
  return path.reduce<TomlValue | undefined>(
    (at, part) => (at !== null && typeof at === 'object' ? (at as Record<string, TomlValue>)[String(part)] : undefined),
    values.value,
  );
}

/// The tables of a kind: `rowsOf('material')`.
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

/// Takes a whole new text as one step. Steps of the same kind (`merge`, such as the keystrokes in one field) that
/// follow each other are undone together, until one ends there.
export function replaceText(next: string, what: string, merge = '') {
  if (next === text.value) return;
  batch(() => {
    if (!merge || merge !== lastMerge) remember({ text: text.value, what });
    future.value = [];
    text.value = next;
  });
  lastMerge = merge;
}
let lastMerge = '';
/// What stands now can be come back to: a field was left, the project was saved or computed.
export function endStep() {
  lastMerge = '';
}

/// Changes the text by edits, as one step. False, and said, where the text does not allow it.
export function edit(what: string, edits: readonly Edit[], merge = ''): boolean {
  try {
    replaceText(edited(text.value, edits), what, merge);
    settleMessages('edit');
    return true;
  } catch (error) {
    const wrong = syntaxError.value;
    const why = wrong
      ? `the text is not TOML (line ${wrong.line}: ${wrong.message}). Correct it under Text first`
      : (error as Error).message;
    say('error', `Could not ${what}: ${why}`, 'edit');
    return false;
  }
}

export function undo() {
  const step = past.value.at(-1);
  if (!step) return;
  batch(() => {
    future.value = [...future.value, { text: text.value, what: step.what }];
    past.value = past.value.slice(0, -1);
    text.value = step.text;
  });
  endStep();
}

export function redo() {
  const step = future.value.at(-1);
  if (!step) return;
  batch(() => {
    past.value = [...past.value, { text: text.value, what: step.what }];
    future.value = future.value.slice(0, -1);
    text.value = step.text;
  });
  endStep();
}

/// Takes up a project: its text as it is now and as it is in the file, and the file's hash.
export function begin(name: string, now: string, saved: string, hash: string | null) {
  settleAll();
  batch(() => {
    ++opening.value;
    file.value = name;
    past.value = [];
    future.value = [];
    savedText.value = saved;
    savedHash.value = hash;
    takenUp.value = null;
    text.value = now;
  });
  endStep();
}

export function leave() {
  settleAll();
  batch(() => {
    ++opening.value;
    file.value = null;
  });
}

/// The text as it was then is in the file, which has this hash and from now on this name.
export function settle(name: string, saved: string, hash: string | null) {
  batch(() => {
    file.value = name;
    savedHash.value = hash;
    savedText.value = saved;
    takenUp.value = null;
  });
  endStep();
}
