// The endings of the files that Talus reads, for texts.

import { fileFormats } from '../generated/schema';

export type FileKind = (typeof fileFormats)[number]['kind'];

/// Whether a file of this name has points as text: a table, and not a cloud of a scanner.
export const isPointText = (name: string) =>
  fileFormats.some(({ ending, kind }) => kind === 'points' && !/^\.la[sz]$/.test(ending) && name.toLowerCase().endsWith(ending));

/// Those of a kind: ".obj, .stl, .ply".
export const endingsOf = (wanted: FileKind) =>
  fileFormats
    .filter(({ kind }) => kind === wanted)
    .map(({ ending }) => ending)
    .join(', ');
