// Detects changes of the open project's file by other programs, when the page gets the focus and before a run.

import { api, Refused } from '../api/client';
import { file, isChanged, markSaved, noteRestored, opening, replaceText, savedHash, setSavedHash } from './document';
import { notify, reportFailure } from '../state/messages';
import { writeInTurn } from '../state/writes';

/// The hash of the file when the user was last informed about it; null if the file does not exist.
let known: string | null = null;
export const setKnownFile = (hash: string | null) => (known = hash);

async function readFile(name: string): Promise<{ text: string; saved: string | null }> {
  try {
    return await api.project(name);
  } catch (error) {
    if (!(error instanceof Refused) || error.status !== 404) throw error;
    return { text: '', saved: null };
  }
}

/// Compares the file with the page, after pending writes of this page.
const compare = (name: string, asked: number) =>
  writeInTurn(async () => {
    const { text: now, saved } = await readFile(name);
    if (opening.value !== asked || file.value !== name || saved === savedHash.value || saved === known) return;
    setKnownFile(saved);
    if (saved === null) {
      setSavedHash(null); // saving creates it again
      noteRestored('of a deleted file');
    } else if (isChanged.value) {
      noteRestored('of an earlier file');
    } else {
      replaceText(now, 'reload the file');
      markSaved(name, now, saved);
      notify('note', `Another program changed ${name}. It was reloaded.`);
    }
  });

/// Reloads a changed file if the page has no unsaved changes; otherwise informs the user.
export async function checkFile() {
  if (file.value === null) return;
  try {
    await compare(file.value, opening.value);
  } catch (error) {
    if (error instanceof Refused) reportFailure(error);
  }
}

addEventListener('focus', () => void checkFile());
