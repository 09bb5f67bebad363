// Another program may change the file of the open project. Looked for where the page comes to the front, and before the
// rocks are thrown.

import { api, Refused } from '../api/client';
import { file, isChanged, opening, replaceText, savedHash, settle, takenUp } from './document';
import { say, sayFailure } from './messages';
import { writeInTurn } from './writes';

/// Of the file on the disk, when the user was told of it last; null: there is none.
let seen: string | null = null;
export const sawFile = (hash: string | null) => (seen = hash);

async function readFile(name: string): Promise<{ text: string; saved: string | null }> {
  try {
    return await api.project(name);
  } catch (error) {
    if (!(error instanceof Refused) || error.status !== 404) throw error;
    return { text: '', saved: null };
  }
}

/// After what this page writes itself.
const look = (name: string, asked: number) =>
  writeInTurn(async () => {
    const { text: now, saved } = await readFile(name);
    if (opening.value !== asked || file.value !== name || saved === savedHash.value || saved === seen) return;
    sawFile(saved);
    if (saved === null) {
      savedHash.value = null; // saving writes it anew
      takenUp.value = 'of a file that is gone';
    } else if (isChanged.value) {
      takenUp.value = 'of an earlier file';
    } else {
      replaceText(now, 'read the file again');
      settle(name, now, saved);
      say('note', `${name} was changed by another program, and was read again.`);
    }
  });

/// An unchanged page takes what the file says by now; of a changed one the user is told.
export async function lookAtFile() {
  if (file.value === null) return;
  try {
    await look(file.value, opening.value);
  } catch (error) {
    if (error instanceof Refused) sayFailure(error);
  }
}

addEventListener('focus', () => void lookAtFile());
