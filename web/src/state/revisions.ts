// Which draft of a project comes from which: every change of one has a revision, the tab of a browser that made it and
// as its how manyeth, such as "3f9a.12".

import type { Draft, KeptDraft } from '../api/types';

/// A draft that the server does not have, or may not have.
export interface LocalDraft extends Draft {
  revision: string;
  /// Of the server's draft that it was made of; null: of none.
  after: string | null;
  /// When it was kept: milliseconds, as Date.now().
  time: number;
}

export const tabOf = (revision: string) => revision.slice(0, revision.lastIndexOf('.'));
const countOf = (revision: string) => Number(revision.slice(revision.lastIndexOf('.') + 1));

/// Whether a draft with these revisions is that one, or comes from it.
const comesFrom = (revisions: readonly string[], revision: string) =>
  revisions.some((last) => tabOf(last) === tabOf(revision) && countOf(last) >= countOf(revision));

/// Whether the local one was made of the server's.
function goesOnFrom({ revision, after }: LocalDraft, { revisions }: KeptDraft): boolean {
  const last = revisions.at(-1) ?? null;
  return after === last || (last !== null && tabOf(last) === tabOf(revision) && countOf(last) < countOf(revision));
}

export interface Choice {
  /// With which the project goes on; null: with the file.
  taken: KeptDraft | LocalDraft | null;
  /// Drafts of which nobody can say that they are older.
  aside: LocalDraft[];
  /// Drafts from which others come, or that say what the file says.
  outdone: LocalDraft[];
}

/// With which of its drafts a project goes on.
export function choiceOf(saved: string, kept: KeptDraft | null, locals: readonly LocalDraft[]): Choice {
  const isOutdone = (local: LocalDraft) =>
    local.text === saved ||
    (kept !== null && (local.text === kept.text || comesFrom(kept.revisions, local.revision)));
  const outdone = locals.filter(isOutdone);
  const left = locals.filter((local) => !isOutdone(local)).sort((a, b) => b.time - a.time);
  const newest = kept === null ? left[0] : left.find((local) => goesOnFrom(local, kept));
  return { taken: newest ?? kept, aside: left.filter((local) => local !== newest), outdone };
}
