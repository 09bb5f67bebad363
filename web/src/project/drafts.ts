// Drafts of unsaved changes. They are sent to the server within a second. If the server does not respond, or has a draft of
// another tab that this one is not based on, they are stored in the browser.

import { effect, signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Draft, KeptDraft } from '../api/types';
import { storageKey, workplace } from '../state/about';
import { file, isChanged, opening, savedHash, text } from './document';
import { removeLocal, storeLocal } from './localDrafts';
import { tabOf, type LocalDraft } from './revisions';
import { owned } from '../state/owned';
import { writeInTurn } from '../state/writes';

/// Identifies this page until it is reloaded.
const tab = Math.random().toString(36).slice(2, 12);
let changes = 0;

/// Whether the open project is also being changed in another tab or browser.
const [changedElsewhere, noteElsewhere] = owned(signal(false));
export const isChangedElsewhere = changedElsewhere;
export const dismissElsewhere = () => noteElsewhere(false);
/// Other drafts of the open project, until the user decides about them.
export const [draftsAside, setAside] = owned(signal<readonly LocalDraft[]>([]));

/// The server's draft of a project, as far as this tab knows; undefined if uncertain.
interface Known {
  draft: Draft | null | undefined;
  revision: string | null;
}
const known = new Map<string, Known>();
const knownOf = (name: string): Known => known.get(name) ?? { draft: null, revision: null };

/// The revision of this tab's next draft, and that of the server's draft it is based on.
export const nextRevision = (name: string) => ({ revision: `${tab}.${++changes}`, after: knownOf(name).revision });

/// Records the server's draft when a project is opened.
export function recordDraft(name: string, draft: KeptDraft | null) {
  known.set(name, { draft, revision: draft?.revisions.at(-1) ?? null });
}

const draftNow = (): Draft | null => (isChanged.value ? { text: text.value, saved: savedHash.value } : null);

function isKnown(name: string, draft: Draft | null): boolean {
  const there = knownOf(name).draft;
  if (!there || !draft) return there === draft;
  return there.text === draft.text && there.saved === draft.saved;
}

/// Stores a draft of this tab in the browser.
export const storeHere = (name: string, draft: Draft, of = nextRevision(name)) =>
  storeLocal(name, { text: draft.text, saved: draft.saved, ...of, time: Date.now() });

/// Deletes drafts from the browser.
export function discard(name: string, drafts: readonly LocalDraft[]) {
  for (const { revision } of drafts) removeLocal(name, tabOf(revision));
  setAside(draftsAside.value.filter((draft) => !drafts.includes(draft)));
}

// Tabs with the same project notify each other of drafts. If one tab deletes the server's draft, others with unsaved
// changes send theirs again.
interface DraftNews {
  key: string;
  isDeleted: boolean;
}
const keyOf = (name: string) => storageKey('draft', name);
const tabs = new BroadcastChannel('drafts of tabs');
tabs.onmessage = ({ data }: MessageEvent<DraftNews>) => {
  const name = file.value;
  if (name === null || keyOf(name) !== data.key) return;
  if (!data.isDeleted) {
    noteElsewhere(true);
  } else if (isChanged.value) {
    known.set(name, { ...knownOf(name), draft: undefined });
    void storeNow();
  }
};

async function sendDraft(name: string, draft: Draft | null) {
  const of = nextRevision(name);
  try {
    await api.keepDraft(name, draft, of, workplace());
    known.set(name, { draft, revision: draft && of.revision });
    removeLocal(name, tab);
  } catch (error) {
    if (draft) storeHere(name, draft, of);
    else removeLocal(name, tab);
    if (draft && error instanceof Refused && error.status === 409 && name === file.value)
      noteElsewhere(true);
  }
  tabs.postMessage({ key: keyOf(name), isDeleted: draft === null } satisfies DraftNews);
}

export const deleteDraft = (name: string) => writeInTurn(() => sendDraft(name, null));

/// The opening in which this tab had unsaved changes. Otherwise it does not delete a draft, which is another tab's.
let changedIn: number | null = null;
effect(() => {
  if (isChanged.value) changedIn = opening.value;
});
effect(() => {
  void opening.value;
  noteElsewhere(false);
  setAside([]);
});

let timer: ReturnType<typeof setTimeout> | undefined;
export async function storeNow() {
  clearTimeout(timer);
  const [name, draft] = [file.value, draftNow()];
  if (name === null || changedIn !== opening.value) return;
  await writeInTurn(async () => {
    if (isKnown(name, draft)) removeLocal(name, tab);
    else await sendDraft(name, draft);
  });
}

effect(() => {
  void [file.value, text.value, isChanged.value];
  clearTimeout(timer);
  timer = setTimeout(() => void storeNow(), 400);
});

/// When the page closes, sends a draft that the server does not have. A keepalive request limits its size, so it is also
/// stored in the browser.
export function storeOnLeaving() {
  const [name, draft] = [file.value, draftNow()];
  if (name === null || draft === null || isKnown(name, draft)) return;
  const of = nextRevision(name);
  storeHere(name, draft, of);
  const body = JSON.stringify({ file: name, ...draft, ...of, workplace: workplace() });
  const headers = { 'Content-Type': 'application/json' };
  fetch('/api/draft', { method: 'PUT', keepalive: true, headers, body }).catch(() => undefined);
}
