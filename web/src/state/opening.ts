// Which project is open: one of the folder, a new one, none.

import { batch, effect } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { ProjectText } from '../api/types';
import { about, keptKey } from './about';
import { begin, file, leave, replaceText, savedHash, takenUp } from './document';
import { draftsAside, keepHere, keepNow, letGo, takeNote } from './drafts';
import { sawFile } from './fileOnDisk';
import { localDraftsOf } from './localDrafts';
import { choiceOf, type LocalDraft } from './revisions';

// A tab that is reloaded opens its project again.
const ownKey = () => keptKey('project', 'this tab');
effect(() => {
  if (file.value !== null) sessionStorage.setItem(ownKey(), file.value);
});
export const lastOpen = () => sessionStorage.getItem(ownKey()) ?? about.value?.project ?? null;

async function read(name: string, locals: readonly LocalDraft[]): Promise<ProjectText> {
  try {
    return await api.project(name);
  } catch (error) {
    // Never saved, and the server did not hear of it before it went.
    if (!(error instanceof Refused) || error.status !== 404 || locals.length === 0) throw error;
    return { file: name, text: '', saved: null, draft: null };
  }
}

/// Opens a project of the folder; a draft that was left is taken up, and the saved text is one undo away. One of a file
/// that has been changed since still has that file's hash: it does not overwrite the new one unasked.
export async function open(name: string) {
  const locals = localDraftsOf(name);
  const project = await read(name, locals);
  const { taken: draft, aside, outdone } = choiceOf(project.text, project.draft, locals);
  begin(name, project.text, project.text, project.saved);
  takeNote(name, project.draft);
  sawFile(project.saved);
  letGo(name, outdone);
  draftsAside.value = aside;
  if (draft === null) return;
  if ('revision' in draft) {
    keepHere(name, draft);
    letGo(name, [draft]);
  }
  const isOfTheFile = project.saved === null || draft.saved === project.saved;
  batch(() => {
    replaceText(draft.text, 'take up the draft');
    if (!isOfTheFile) savedHash.value = draft.saved;
    takenUp.value = isOfTheFile ? 'of the file' : 'of an earlier file';
  });
}

/// Begins a project that has no file yet.
export function start(name: string, first: string) {
  begin(name, first, '', null);
  takeNote(name, null);
  sawFile(null);
}

export function close() {
  void keepNow();
  sessionStorage.removeItem(ownKey());
  leave();
}
