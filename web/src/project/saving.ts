// Saves the project's file, also under another name, and handles conflicts with other programs.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import { leftOut } from './leftOut';
import { workplace } from '../state/about';
import { file, markSaved, opening, replaceText, savedHash, text } from './document';
import { deleteDraft, nextRevision } from './drafts';
import { setKnownFile } from './fileOnDisk';
import { notify, reportFailure, resolve } from '../state/messages';
import { owned } from '../state/owned';
import { writeInTurn } from '../state/writes';

/// Why the file was not saved: another program changed it. Null once the user has decided.
export const [conflict, setConflict] = owned(signal<string | null>(null));
export const [savingAs, askName] = owned(signal(false));

/// `replaced` returns the hash of the file to replace; it is called when earlier writes are done.
function write(name: string, replaced: () => string | null | Promise<string | null>): Promise<void> {
  const asked = opening.value;
  return writeInTurn(async () => {
    if (opening.value !== asked) return; // closed in the meantime; the draft has the text
    const now = text.value;
    const before = await replaced();
    const { saved } = await api.saveProject(name, { text: now, saved: before }, nextRevision(name), workplace());
    setKnownFile(saved);
    if (opening.value === asked) markSaved(name, now, saved);
    resolve('save');
    notify('saved', `Saved ${name}${leftOut()}`);
  });
}

const isConflict = (error: unknown) => error instanceof Refused && error.status === 409;

export async function save() {
  const asked = opening.value;
  if (file.value === null) return;
  try {
    await write(file.value, () => savedHash.value);
  } catch (error) {
    if (isConflict(error) && opening.value === asked) setConflict((error as Refused).message);
    else reportFailure(error, 'save');
  }
}

/// Saves the project, whatever the file contains now.
export async function overwrite() {
  const name = file.value;
  if (name === null) return;
  await write(name, async () => {
    try {
      return (await api.project(name)).saved;
    } catch (error) {
      if (error instanceof Refused && error.status === 404) return null;
      throw error;
    }
  });
}

/// Saves the project under another name, which it keeps. Returns false if that file exists and `replace` is false.
export async function saveAs(name: string, replace = false): Promise<boolean> {
  const old = file.value;
  try {
    await write(name, async () => (replace ? (await api.project(name)).saved : null));
  } catch (error) {
    if (isConflict(error) && !replace) return false;
    throw error;
  }
  if (old !== null && old !== name) await deleteDraft(old);
  return true;
}

/// Loads the file again, as a step that can be undone.
export async function reload() {
  const [name, asked] = [file.value, opening.value];
  if (name === null) return;
  const project = await api.project(name);
  if (opening.value !== asked) return;
  replaceText(project.text, 'reload the file');
  markSaved(name, project.text, project.saved);
}
