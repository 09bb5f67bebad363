// Writing the project's file: as it is, under another name, and what to do when it was changed meanwhile.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import { leftOut } from '../model/leftOut';
import { workplace } from './about';
import { file, opening, replaceText, savedHash, settle, text } from './document';
import { dropDraft, nextRevision } from './drafts';
import { sawFile } from './fileOnDisk';
import { say, sayFailure, settle as settleMessages } from './messages';
import { writeInTurn } from './writes';

/// Why the file was not written: it is another one than was read. Until the user has said what to do.
export const conflict = signal<string | null>(null);
export const savingAs = signal(false);

/// `replaced`: asked for in its turn, when what was asked before is written.
function write(name: string, replaced: () => string | null | Promise<string | null>): Promise<void> {
  const asked = opening.value;
  return writeInTurn(async () => {
    if (opening.value !== asked) return; // left meanwhile; the draft has it
    const now = text.value;
    const before = await replaced();
    const { saved } = await api.saveProject(name, { text: now, saved: before }, nextRevision(name), workplace());
    sawFile(saved);
    if (opening.value === asked) settle(name, now, saved);
    settleMessages('save');
    say('saved', `Saved ${name}${leftOut()}`);
  });
}

const isConflict = (error: unknown) => error instanceof Refused && error.status === 409;

export async function save() {
  const asked = opening.value;
  if (file.value === null) return;
  try {
    await write(file.value, () => savedHash.value);
  } catch (error) {
    if (isConflict(error) && opening.value === asked) conflict.value = (error as Refused).message;
    else sayFailure(error, 'save');
  }
}

/// Whatever the file says by now, it says this from now on.
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

/// Under another name, which the project has from then on. False: there is such a file.
export async function saveAs(name: string, replace = false): Promise<boolean> {
  const old = file.value;
  try {
    await write(name, async () => (replace ? (await api.project(name)).saved : null));
  } catch (error) {
    if (isConflict(error) && !replace) return false;
    throw error;
  }
  if (old !== null && old !== name) await dropDraft(old);
  return true;
}

/// Takes the file as it is on the disk, as a step that can be undone.
export async function readAgain() {
  const [name, asked] = [file.value, opening.value];
  if (name === null) return;
  const project = await api.project(name);
  if (opening.value !== asked) return;
  replaceText(project.text, 'read the file again');
  settle(name, project.text, project.saved);
}
