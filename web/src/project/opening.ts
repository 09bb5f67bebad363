// Opens and closes projects.

import { batch, effect } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { ProjectText } from '../api/types';
import { about, storageKey } from '../state/about';
import { begin, file, leave, replaceText, noteRestored, setSavedHash } from './document';
import { discard, recordDraft, setAside, storeHere, storeNow } from './drafts';
import { storeThumbnail } from './thumbnail';
import { setKnownFile } from './fileOnDisk';
import { localDraftsOf } from './localDrafts';
import { choiceOf, type LocalDraft } from './revisions';

// A tab that is reloaded opens its project again.
const ownKey = () => storageKey('project', 'this tab');
effect(() => {
  if (file.value !== null) sessionStorage.setItem(ownKey(), file.value);
});
export const lastOpen = () => sessionStorage.getItem(ownKey()) ?? about.value?.project ?? null;

async function read(name: string, locals: readonly LocalDraft[]): Promise<ProjectText> {
  try {
    return await api.project(name);
  } catch (error) {
    // Never saved, and the draft never reached the server.
    if (!(error instanceof Refused) || error.status !== 404 || locals.length === 0) throw error;
    return { file: name, text: '', saved: null, draft: null };
  }
}

/// Opens a project of the folder and restores its draft, if any. Undo returns to the saved text; of a project that has no
/// file, the draft is the first text. A draft of an earlier file keeps that file's hash, so that saving does not overwrite
/// the new file without asking.
export async function open(name: string) {
  const locals = localDraftsOf(name);
  const project = await read(name, locals);
  const { chosen: draft, aside, superseded } = choiceOf(project.text, project.draft, locals);
  const first = project.saved === null && draft !== null ? draft.text : project.text;
  begin(name, first, project.text, project.saved);
  recordDraft(name, project.draft);
  setKnownFile(project.saved);
  discard(name, superseded);
  setAside(aside);
  if (draft === null) return;
  if ('revision' in draft) {
    storeHere(name, draft);
    discard(name, [draft]);
  }
  const isOfTheFile = project.saved === null || draft.saved === project.saved;
  batch(() => {
    replaceText(draft.text, 'restore the draft');
    if (!isOfTheFile) setSavedHash(draft.saved);
    noteRestored(isOfTheFile ? 'of the file' : 'of an earlier file');
  });
}

/// Opens a new project without a file.
export function start(name: string, first: string) {
  begin(name, first, '', null);
  recordDraft(name, null);
  setKnownFile(null);
}

export function close() {
  storeThumbnail();
  void storeNow();
  sessionStorage.removeItem(ownKey());
  leave();
}
