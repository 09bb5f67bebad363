// Where inputs are from: sources of materials' values, and files with their checksums.

import type { Group } from '../figures/plot';
import { element } from './figure';
import { number, wordsOf } from './format';
import { runs } from './run';
import { forEachRun } from './runTables';
import { table, type Row } from './tables';

/// Sources of materials' values that are those of the library.
export function materialSources(parent: Group) {
  forEachRun(
    'Sources of the materials’ values',
    (run) => run.summary.inputs?.material_sources ?? [],
    (caption, list) =>
      table(parent, {
        caption,
        head: [['Material', 'Library', 'Values', 'Source']],
        rows: list.map(({ material, like, keys, source }): Row => {
          const values = keys.map((key) => wordsOf(key).toLowerCase()).join(', ');
          return [material, like, values, source];
        }),
      }),
  );
}

export function inputFiles(parent: Group) {
  forEachRun(
    'Input files',
    (run) => run.summary.inputs?.files ?? [],
    (caption, list) =>
      table(parent, {
        caption,
        head: [['File', { text: 'Size', unit: 'bytes' }, 'SHA-256']],
        rows: list.map(({ name, bytes, sha256 }): Row => {
          const draw = (cell: Group) => element(cell, 'code', sha256 || '–', { class: 'sum' });
          return [name, number(bytes, 15), { text: '', draw }];
        }),
        numeric: (column) => column === 1,
      }),
  );
  if (!runs.some(({ summary }) => summary.inputs)) return;
  const text =
    'Files as they were when the run began; paths are relative to the project file. sha256sum FILE, or Get-FileHash FILE ' +
    'on Windows, prints the checksum of a file.';
  element(parent, 'p', text, { class: 'quiet' });
}
