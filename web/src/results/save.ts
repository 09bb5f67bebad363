// Plots and tables as files, or to the clipboard.

import { say, sayFailure } from '../state/messages';
import { counted } from '../ui/format';

export type Cell = string | number;

export function saveFile(name: string, content: Blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/// RFC 4180.
function csvText(rows: readonly (readonly Cell[])[]): string {
  const cell = (value: Cell) => {
    const text = String(value);
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return rows.map((row) => `${row.map(cell).join(',')}\r\n`).join('');
}

export function saveCsv(name: string, rows: readonly (readonly Cell[])[]) {
  saveFile(`${name}.csv`, new Blob([csvText(rows)], { type: 'text/csv' }));
}

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
