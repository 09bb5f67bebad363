// The first text of a project, and the file that it is to have.

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

/// "cliff-above-b12.toml" of "Cliff above B12", or with a number where there is such a file.
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
