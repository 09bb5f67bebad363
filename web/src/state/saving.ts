// Writing the project's file: as it is, under another name, and what to do when it was changed meanwhile.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import { file, replaceText, savedHash, settle, text } from './document';
import { say, sayFailure } from './messages';

/// Why the file was not written: it is another one than was read. Until the user has said what to do.
export const conflict = signal<string | null>(null);
export const savingAs = signal(false);

async function write(name: string, hash: string | null) {
  const now = text.value;
  const { saved } = await api.saveProject(name, now, hash);
  settle(name, now, saved);
  say('saved', `Saved ${name}`);
}

export async function save() {
  if (file.value === null) return;
  try {
    await write(file.value, savedHash.value);
  } catch (error) {
    if (error instanceof Refused && error.status === 409) conflict.value = error.message;
    else sayFailure(error);
  }
}

/// Whatever the file says by now, it says this from now on.
export async function overwrite() {
  if (file.value === null) return;
  const there = await api.project(file.value).catch((error: unknown) => {
    if (error instanceof Refused && error.status === 404) return { saved: null };
    throw error;
  });
  await write(file.value, there.saved);
}

/// Under another name, which the project has from then on. False: there is such a file.
export async function saveAs(name: string, replace = false): Promise<boolean> {
  const old = file.value;
  let hash: string | null = null;
  if (replace) hash = (await api.project(name)).saved;
  try {
    await write(name, hash);
  } catch (error) {
    if (error instanceof Refused && error.status === 409 && !replace) return false;
    throw error;
  }
  if (old !== null && old !== name) await api.keepDraft(old, null);
  return true;
}

/// Takes the file as it is on the disk, as a step that can be undone.
export async function readAgain() {
  if (file.value === null) return;
  const project = await api.project(file.value);
  replaceText(project.text, 'read the file again');
  settle(file.value, project.text, project.saved);
}
