// The endings of the files that Talus reads, for texts.

import { fileFormats } from '../generated/schema';

export type FileKind = (typeof fileFormats)[number]['kind'];

/// Those of a kind: ".obj, .stl, .ply".
export const endingsOf = (wanted: FileKind) =>
  fileFormats
    .filter(({ kind }) => kind === wanted)
    .map(({ ending }) => ending)
    .join(', ');
