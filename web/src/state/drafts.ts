// Drafts: what is not saved is kept by the server within a second, and in the browser, should the server be gone, or
// have the draft of another tab that this one does not come from.

import { effect, signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Draft, KeptDraft } from '../api/types';
import { keptKey, workplace } from './about';
import { file, isChanged, opening, savedHash, text } from './document';
import { forgetLocal, keepLocally } from './localDrafts';
import { tabOf, type LocalDraft } from './revisions';
import { writeInTurn } from './writes';

/// This page, as long as it is loaded.
const tab = Math.random().toString(36).slice(2, 12);
let changes = 0;

/// Whether the open project is changed in another tab or browser, too.
export const isChangedElsewhere = signal(false);
/// Drafts of the open project that do not come from what is shown, until the user has said what to do with them.
export const draftsAside = signal<LocalDraft[]>([]);

/// What the server has of a project, as far as this tab knows; `draft` undefined: not sure.
interface Known {
  draft: Draft | null | undefined;
  revision: string | null;
}
const known = new Map<string, Known>();
const knownOf = (name: string): Known => known.get(name) ?? { draft: null, revision: null };

/// The revision of what this tab sends next, and that of the server's draft that it was made of.
export const nextRevision = (name: string) => ({ revision: `${tab}.${++changes}`, after: knownOf(name).revision });

/// What was found when the project was opened.
export function takeNote(name: string, draft: KeptDraft | null) {
  known.set(name, { draft, revision: draft?.revisions.at(-1) ?? null });
}

const draftNow = (): Draft | null => (isChanged.value ? { text: text.value, saved: savedHash.value } : null);

function isKnown(name: string, draft: Draft | null): boolean {
  const there = knownOf(name).draft;
  if (!there || !draft) return there === draft;
  return there.text === draft.text && there.saved === draft.saved;
}

/// Keeps a draft in this browser, under the name of this tab.
export const keepHere = (name: string, draft: Draft, of = nextRevision(name)) =>
  keepLocally(name, { text: draft.text, saved: draft.saved, ...of, time: Date.now() });

/// What is kept aside for good, or let go.
export function letGo(name: string, drafts: readonly LocalDraft[]) {
  for (const { revision } of drafts) forgetLocal(name, tabOf(revision));
  draftsAside.value = draftsAside.value.filter((draft) => !drafts.includes(draft));
}

// Tabs that have the same project open hear of each other's drafts; whoever takes the draft away is answered by those
// who still have one.
interface Word {
  key: string;
  isTakenAway: boolean;
}
const keyOf = (name: string) => keptKey('draft', name);
const tabs = new BroadcastChannel('drafts of tabs');
tabs.onmessage = ({ data }: MessageEvent<Word>) => {
  const name = file.value;
  if (name === null || keyOf(name) !== data.key) return;
  if (!data.isTakenAway) {
    isChangedElsewhere.value = true;
  } else if (isChanged.value) {
    known.set(name, { ...knownOf(name), draft: undefined });
    void keepNow();
  }
};

async function keepDraft(name: string, draft: Draft | null) {
  const of = nextRevision(name);
  try {
    await api.keepDraft(name, draft, of, workplace());
    known.set(name, { draft, revision: draft && of.revision });
    forgetLocal(name, tab);
  } catch (error) {
    if (draft) keepHere(name, draft, of);
    else forgetLocal(name, tab);
    if (draft && error instanceof Refused && error.status === 409 && name === file.value)
      isChangedElsewhere.value = true;
  }
  tabs.postMessage({ key: keyOf(name), isTakenAway: draft === null } satisfies Word);
}

export const dropDraft = (name: string) => writeInTurn(() => keepDraft(name, null));

/// In which opening this tab had something to keep: a draft that was always another's is not taken away.
let hadOneIn: number | null = null;
effect(() => {
  if (isChanged.value) hadOneIn = opening.value;
});
effect(() => {
  void opening.value;
  isChangedElsewhere.value = false;
  draftsAside.value = [];
});

let keeping: ReturnType<typeof setTimeout> | undefined;
export async function keepNow() {
  clearTimeout(keeping);
  const [name, draft] = [file.value, draftNow()];
  if (name === null || hadOneIn !== opening.value) return;
  await writeInTurn(async () => {
    if (isKnown(name, draft)) forgetLocal(name, tab);
    else await keepDraft(name, draft);
  });
}

effect(() => {
  void [file.value, text.value, isChanged.value];
  clearTimeout(keeping);
  keeping = setTimeout(() => void keepNow(), 400);
});

/// A tab that closes within that time still sends what the server does not have; what is too long for that the browser
/// has.
export function keepOnLeaving() {
  const [name, draft] = [file.value, draftNow()];
  if (name === null || draft === null || isKnown(name, draft)) return;
  const of = nextRevision(name);
  keepHere(name, draft, of);
  const body = JSON.stringify({ file: name, ...draft, ...of, workplace: workplace() });
  const headers = { 'Content-Type': 'application/json' };
  fetch('/api/draft', { method: 'PUT', keepalive: true, headers, body }).catch(() => undefined);
}
