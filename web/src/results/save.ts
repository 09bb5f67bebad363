// Tables to the clipboard, and names of files.

import type { Cell } from '../figures/files';
import { say, sayFailure } from '../state/messages';
import { counted } from '../ui/format';

/// For a spreadsheet: columns apart by tabs.
export function copyRows(rows: readonly (readonly Cell[])[]) {
  const text = rows.map((row) => row.map((value) => String(value).replace(/[\t\r\n]+/g, ' ')).join('\t')).join('\n');
  navigator.clipboard.writeText(text).then(
    () => say('note', `${counted(rows.length - 1, 'row')} copied, to be pasted into a spreadsheet`),
    sayFailure,
  );
}

/// A name for a file of words: "Tutorial 1, Fence" becomes "tutorial-1-fence".
export function fileName(...words: string[]): string {
  const plain = words
    .join(' ')
    .normalize('NFKD')
    .replace(/[^A-Za-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '');
  return plain.toLowerCase().slice(0, 100) || 'talus';
}
