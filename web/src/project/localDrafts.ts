// Drafts stored in the browser because they could not be sent to the server: one per tab, so that none replaces another.

import type { Draft } from '../api/types';
import { storageKey } from '../state/about';
import { tabOf, type LocalDraft } from './revisions';

const keyOf = (name: string) => storageKey('draft', name);

export function localDraftsOf(name: string): LocalDraft[] {
  const kept = localStorage.getItem(keyOf(name));
  if (kept === null) return [];
  const found = JSON.parse(kept) as LocalDraft[] | Draft;
  // The earlier format: one draft without a revision for all tabs.
  return Array.isArray(found) ? found : [{ ...found, revision: 'earlier.0', after: null, time: 0 }];
}

/// The projects with a local draft.
export function localDrafts(): string[] {
  const before = keyOf('');
  return Object.keys(localStorage).flatMap((key) => (key.startsWith(before) ? [key.slice(before.length)] : []));
}

function write(name: string, drafts: readonly LocalDraft[]) {
  if (drafts.length === 0) return localStorage.removeItem(keyOf(name));
  try {
    localStorage.setItem(keyOf(name), JSON.stringify(drafts));
  } catch {
    // The browser's storage is full; the server may have the draft.
  }
}

const ofOthers = (name: string, tab: string) => localDraftsOf(name).filter(({ revision }) => tabOf(revision) !== tab);

/// Replaces the draft of the same tab.
export const storeLocal = (name: string, draft: LocalDraft) =>
  write(name, [...ofOthers(name, tabOf(draft.revision)), draft]);

export const removeLocal = (name: string, tab: string) => write(name, ofOthers(name, tab));
