// Copying tables to the clipboard, and file names.

import type { Cell } from '../figures/files';
import { notify, reportFailure } from '../state/messages';
import { counted } from '../units/numbers';

/// Copies rows for a spreadsheet, with columns separated by tabs.
export function copyRows(rows: readonly (readonly Cell[])[]) {
  const text = rows.map((row) => row.map((value) => String(value).replace(/[\t\r\n]+/g, ' ')).join('\t')).join('\n');
  navigator.clipboard.writeText(text).then(
    () => notify('note', `${counted(rows.length - 1, 'row')} copied. Paste into a spreadsheet.`),
    reportFailure,
  );
}

/// A file name from words: "tutorial-1-fence" for "Tutorial 1, Fence".
export function fileName(...words: string[]): string {
  const plain = words
    .join(' ')
    .normalize('NFKD')
    .replace(/[^A-Za-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '');
  return plain.toLowerCase().slice(0, 100) || 'talus';
}
