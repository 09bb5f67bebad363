// Drafts: what is not saved is kept by the server within a second, and in the browser, should the server be gone.

import { effect } from '@preact/signals';
import { api } from '../api/client';
import type { Draft } from '../api/types';
import { keptKey, workplace } from './about';
import { file, isChanged, opening, savedHash, text } from './document';
import { writeInTurn } from './writes';

const keyOf = (name: string) => keptKey('draft', name);

/// A draft that could not reach the server.
export function localDraft(name: string): Draft | null {
  const kept = localStorage.getItem(keyOf(name));
  return kept === null ? null : (JSON.parse(kept) as Draft);
}

/// Which projects have one.
export function localDrafts(): string[] {
  const before = keyOf('');
  return Object.keys(localStorage).flatMap((key) => (key.startsWith(before) ? [key.slice(before.length)] : []));
}

export const forgetLocal = (name: string) => localStorage.removeItem(keyOf(name));

function keepLocally(name: string, draft: Draft | null) {
  if (draft === null) return forgetLocal(name);
  try {
    localStorage.setItem(keyOf(name), JSON.stringify(draft));
  } catch {
    // The browser has no more room; the server may have it.
  }
}

const draftNow = (): Draft | null => (isChanged.value ? { text: text.value, saved: savedHash.value } : null);

// A project has one draft, also where it is open in several tabs: whoever takes it away tells the others.
const tabs = new BroadcastChannel('drafts that were taken away');
tabs.onmessage = ({ data }: MessageEvent<string>) => {
  if (file.value !== null && keyOf(file.value) === data && isChanged.value) void keepNow();
};

async function keepDraft(name: string, draft: Draft | null) {
  try {
    await api.keepDraft(name, draft, workplace());
    forgetLocal(name);
  } catch {
    keepLocally(name, draft);
  }
  if (draft === null) tabs.postMessage(keyOf(name));
}

export const dropDraft = (name: string) => writeInTurn(() => keepDraft(name, null));

/// In which opening this tab had something to keep: a draft that was always another's is not taken away.
let hadOneIn: number | null = null;
effect(() => {
  if (isChanged.value) hadOneIn = opening.value;
});

let keeping: ReturnType<typeof setTimeout> | undefined;
export async function keepNow() {
  clearTimeout(keeping);
  const [name, draft] = [file.value, draftNow()];
  if (name !== null && hadOneIn === opening.value) await writeInTurn(() => keepDraft(name, draft));
}

effect(() => {
  void [file.value, text.value, isChanged.value];
  clearTimeout(keeping);
  keeping = setTimeout(() => void keepNow(), 400);
});

/// A tab that closes within that time still sends what it has; what is too long for that the browser has.
export function keepOnLeaving() {
  const draft = draftNow();
  if (file.value === null || draft === null) return;
  keepLocally(file.value, draft);
  const body = JSON.stringify({ file: file.value, ...draft, workplace: workplace() });
  const headers = { 'Content-Type': 'application/json' };
  fetch('/api/draft', { method: 'PUT', keepalive: true, headers, body }).catch(() => undefined);
}
