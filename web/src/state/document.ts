// The project that is open: its text, and every step that led to it. The text is the truth; forms and pictures follow
// from it, and a change is a change of the text.

import { batch, computed, effect, signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import { edited, valuesOf, type Edit, type Path } from '../toml/edit';
import type { TomlTable, TomlValue } from '../toml/format';
import { chosen, chosenRock } from './view';

interface Step {
  text: string;
  what: string; // for "Undo: ..."
}

const mostSteps = 500;
const mostCharacters = 50_000_000; // of all steps together

/// The file's name, relative to the folder; null: nothing is open.
export const file = signal<string | null>(null);
/// Its name without folders and ending: what a project without a name is called.
export const fileStem = () => (file.value ?? '').replace(/^.*\/|\.toml$/g, '');
export const text = signal('');
/// The hash of the file as it was read or written last; null: it was never saved.
export const savedHash = signal<string | null>(null);
const savedText = signal('');
const past = signal<Step[]>([]);
const future = signal<Step[]>([]);

export const isChanged = computed(() => text.value !== savedText.value || savedHash.value === null);
export const undoes = computed(() => past.value.at(-1)?.what ?? null);
export const redoes = computed(() => future.value.at(-1)?.what ?? null);
/// A draft of an earlier session that was taken up, until the user has seen it.
export const isDraft = signal(false);

/// What the text says; while it is no TOML (in the text editor), what it said last.
let lastValues: TomlTable = {};
export const syntaxError = signal<{ line: number; message: string } | null>(null);
export const values = computed<TomlTable>(() => {
  try {
    lastValues = valuesOf(text.value);
  } catch {
    // Said by `syntaxError`, and by the server, with the line.
  }
  return lastValues;
});
effect(() => {
  try {
    valuesOf(text.value);
    syntaxError.value = null;
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
export function rowsOf(key: string): TomlTable[] {
  const rows = values.value[key];
  return Array.isArray(rows) ? (rows as TomlTable[]) : [];
}

function remember(step: Step) {
  const steps = [...past.value, step].slice(-mostSteps);
  let characters = steps.reduce((sum, { text: part }) => sum + part.length, 0);
  while (steps.length > 1 && characters > mostCharacters) characters -= steps.shift()!.text.length;
  past.value = steps;
}

/// Takes a whole new text as one step. Steps of the same kind (`merge`, such as the keystrokes in one field) that follow
/// each other are undone together.
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

/// Changes the text by edits, as one step.
export function edit(what: string, edits: readonly Edit[], merge = '') {
  replaceText(edited(text.value, edits), what, merge);
}

export function undo() {
  const step = past.value.at(-1);
  if (!step) return;
  batch(() => {
    future.value = [...future.value, { text: text.value, what: step.what }];
    past.value = past.value.slice(0, -1);
    text.value = step.text;
  });
  lastMerge = '';
}

export function redo() {
  const step = future.value.at(-1);
  if (!step) return;
  batch(() => {
    past.value = [...past.value, { text: text.value, what: step.what }];
    future.value = future.value.slice(0, -1);
    text.value = step.text;
  });
  lastMerge = '';
}

function begin(name: string, now: string, saved: string, hash: string | null) {
  batch(() => {
    file.value = name;
    past.value = [];
    future.value = [];
    savedText.value = saved;
    savedHash.value = hash;
    text.value = now;
  });
  lastMerge = '';
  sessionStorage.setItem('file', name);
}

/// Opens a project of the folder; a draft that was left is taken up, and the saved text is one undo away.
export async function open(name: string) {
  const local = localDraft(name);
  const project = await api.project(name).catch((error: unknown) => {
    // Never saved, and the server did not hear of it before it went.
    if (error instanceof Refused && error.status === 404 && local !== null)
      return { text: '', saved: null, draft: local };
    throw error;
  });
  begin(name, project.text, project.text, project.saved);
  const draft = local !== null && local !== project.text ? local : project.draft;
  isDraft.value = draft !== null;
  if (draft !== null) replaceText(draft, 'take up the draft');
}

/// Begins a project that has no file yet.
export function start(name: string, first: string) {
  begin(name, first, '', null);
  isDraft.value = false;
}

export function close() {
  sessionStorage.removeItem('file');
  batch(() => {
    file.value = null;
    chosen.value = null;
    chosenRock.value = null;
  });
}

/// The text as it was then is in the file, which has this hash and from now on this name.
export function settle(name: string, saved: string, hash: string | null) {
  batch(() => {
    file.value = name;
    savedHash.value = hash;
    savedText.value = saved;
    isDraft.value = false;
  });
  sessionStorage.setItem('file', name);
}

// Drafts: what is not saved is kept by the server within a second, and in the browser, should the server be gone.
let keeping: ReturnType<typeof setTimeout> | undefined;
effect(() => {
  const [name, now, changed] = [file.value, text.value, isChanged.value];
  clearTimeout(keeping);
  if (name === null) return;
  keeping = setTimeout(() => void keepDraft(name, changed ? now : null), 400);
});

const localKey = (name: string) => `draft of ${name}`;
async function keepDraft(name: string, draft: string | null) {
  try {
    await api.keepDraft(name, draft);
    localStorage.removeItem(localKey(name));
  } catch {
    if (draft !== null) localStorage.setItem(localKey(name), draft);
  }
}
/// A draft that could not reach the server.
export function localDraft(name: string): string | null {
  return localStorage.getItem(localKey(name));
}
// A tab that closes within that time still sends what it has.
addEventListener('pagehide', () => {
  if (file.value === null || !isChanged.value) return;
  const body = JSON.stringify({ file: file.value, text: text.value });
  localStorage.setItem(localKey(file.value), text.value);
  void fetch('/api/draft', { method: 'PUT', keepalive: true, headers: { 'Content-Type': 'application/json' }, body });
});
