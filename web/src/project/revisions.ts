// Orders the drafts of a project by revisions. A revision is the tab that made a change and its running number, such as
// "3f9a.12".

import type { Draft, KeptDraft } from '../api/types';

/// A draft that may not have reached the server.
export interface LocalDraft extends Draft {
  revision: string;
  /// The revision of the server's draft it is based on; null: none.
  after: string | null;
  /// When it was stored: milliseconds, as Date.now().
  time: number;
}

export const tabOf = (revision: string) => revision.slice(0, revision.lastIndexOf('.'));
const countOf = (revision: string) => Number(revision.slice(revision.lastIndexOf('.') + 1));

/// Whether a draft with these revisions is, or is based on, that revision.
const isBasedOn = (revisions: readonly string[], revision: string) =>
  revisions.some((last) => tabOf(last) === tabOf(revision) && countOf(last) >= countOf(revision));

/// Whether the local draft is a continuation of the server's.
function continues({ revision, after }: LocalDraft, { revisions }: KeptDraft): boolean {
  const last = revisions.at(-1) ?? null;
  return after === last || (last !== null && tabOf(last) === tabOf(revision) && countOf(last) < countOf(revision));
}

export interface Choice {
  /// The draft to continue with; null: the file.
  chosen: KeptDraft | LocalDraft | null;
  /// Drafts that are not known to be older.
  aside: LocalDraft[];
  /// Drafts on which others are based, or that equal the file.
  superseded: LocalDraft[];
}

/// Chooses the draft to continue with.
export function choiceOf(saved: string, kept: KeptDraft | null, locals: readonly LocalDraft[]): Choice {
  const isSuperseded = (local: LocalDraft) =>
    local.text === saved ||
    (kept !== null && (local.text === kept.text || isBasedOn(kept.revisions, local.revision)));
  const superseded = locals.filter(isSuperseded);
  const others = locals.filter((local) => !isSuperseded(local)).sort((a, b) => b.time - a.time);
  const newest = kept === null ? others[0] : others.find((local) => continues(local, kept));
  return { chosen: newest ?? kept, aside: others.filter((local) => local !== newest), superseded };
}
