// The initial text and the file name of a new project.

import { stringText } from '../toml/format';

export type Beginning = { kind: 'section' } | { kind: 'space' } | { kind: 'file'; name: string; key: string };

export function firstText(name: string, beginning: Beginning): string {
  const head = `name = ${stringText(name)}\n\n`;
  switch (beginning.kind) {
    case 'section':
      return `${head}[terrain]\nsection = []\n`;
    case 'space':
      return head;
    case 'file':
      return `${head}[terrain]\n${beginning.key} = ${stringText(beginning.name)}\n`;
  }
}

/// "cliff-above-b12.toml" for "Cliff above B12", numbered if that file exists.
export function fileNameOf(name: string, taken: readonly string[]): string {
  const letters = name
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-+|-+$/g, '');
  const stem = letters || 'project';
  const isTaken = (file: string) => taken.some((other) => other.toLowerCase() === file);
  for (let number = 1; ; ++number) {
    const file = number === 1 ? `${stem}.toml` : `${stem}-${number}.toml`;
    if (!isTaken(file)) return file;
  }
}
