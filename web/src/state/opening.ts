// Which project is open: one of the folder, a new one, none.

import { batch, effect } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { Draft, ProjectText } from '../api/types';
import { about, keptKey } from './about';
import { begin, file, leave, replaceText, savedHash, takenUp } from './document';
import { forgetLocal, keepNow, localDraft } from './drafts';
import { chosen, chosenRock } from './view';

// A tab that is reloaded opens its project again.
const ownKey = () => keptKey('project', 'this tab');
effect(() => {
  if (file.value !== null) sessionStorage.setItem(ownKey(), file.value);
});
export const lastOpen = () => sessionStorage.getItem(ownKey()) ?? about.value?.project ?? null;

async function read(name: string, local: Draft | null): Promise<ProjectText> {
  try {
    return await api.project(name);
  } catch (error) {
    // Never saved, and the server did not hear of it before it went.
    if (!(error instanceof Refused) || error.status !== 404 || local === null) throw error;
    return { file: name, text: '', saved: null, draft: local };
  }
}

/// Opens a project of the folder; a draft that was left is taken up, and the saved text is one undo away. One of a file
/// that has been changed since still has that file's hash: it does not overwrite the new one unasked.
export async function open(name: string) {
  const local = localDraft(name);
  const project = await read(name, local);
  const draft = local ?? project.draft;
  begin(name, project.text, project.text, project.saved);
  if (draft === null || draft.text === project.text) return forgetLocal(name);
  const isOfTheFile = project.saved === null || draft.saved === project.saved;
  batch(() => {
    replaceText(draft.text, 'take up the draft');
    if (!isOfTheFile) savedHash.value = draft.saved;
    takenUp.value = isOfTheFile ? 'of the file' : 'of an earlier file';
  });
}

/// Begins a project that has no file yet.
export const start = (name: string, first: string) => begin(name, first, '', null);

export function close() {
  void keepNow();
  sessionStorage.removeItem(ownKey());
  batch(() => {
    leave();
    chosen.value = null;
    chosenRock.value = null;
  });
}
