// Drafts that could not reach the server, in the browser: one of each tab, since none may take the place of another's.

import type { Draft } from '../api/types';
import { keptKey } from './about';
import { tabOf, type LocalDraft } from './revisions';

const keyOf = (name: string) => keptKey('draft', name);

export function localDraftsOf(name: string): LocalDraft[] {
  const kept = localStorage.getItem(keyOf(name));
  if (kept === null) return [];
  const found = JSON.parse(kept) as LocalDraft[] | Draft;
  // Before drafts had revisions there was one of all tabs.
  return Array.isArray(found) ? found : [{ ...found, revision: 'earlier.0', after: null, time: 0 }];
}

/// Which projects have one.
export function localDrafts(): string[] {
  const before = keyOf('');
  return Object.keys(localStorage).flatMap((key) => (key.startsWith(before) ? [key.slice(before.length)] : []));
}

function write(name: string, drafts: readonly LocalDraft[]) {
  if (drafts.length === 0) return localStorage.removeItem(keyOf(name));
  try {
    localStorage.setItem(keyOf(name), JSON.stringify(drafts));
  } catch {
    // The browser has no more room; the server may have it.
  }
}

const ofOthers = (name: string, tab: string) => localDraftsOf(name).filter(({ revision }) => tabOf(revision) !== tab);

/// In the place of what its tab had before.
export const keepLocally = (name: string, draft: LocalDraft) =>
  write(name, [...ofOthers(name, tabOf(draft.revision)), draft]);

export const forgetLocal = (name: string, tab: string) => write(name, ofOthers(name, tab));
