// The list of projects on the start page: order, search, names of copies.

import type { FolderFile, Run } from '../api/types';

export interface ListedProject {
  file: string;
  /// Null: a draft that was never saved.
  saved: FolderFile | null;
  hasDraft: boolean;
  /// Its last run, and how many it has.
  last: Run | null;
  runs: number;
}

/// When something was last done with a project: its file was saved, or it was run. A draft that was never saved is new.
export function lastUsed({ saved, last }: ListedProject): string {
  if (saved === null) return '9';
  return last !== null && last.begun > saved.modified ? last.begun : saved.modified;
}

/// The projects, the ones last used first. `runs`: newest first.
export function listProjects(folder: readonly FolderFile[], drafted: readonly string[], runs: readonly Run[]): ListedProject[] {
  const saved = folder.filter(({ kind }) => kind === 'project');
  const unsaved = drafted.filter((draft) => !saved.some(({ name }) => name === draft));
  const listed = (name: string, file: FolderFile | null): ListedProject => {
    const own = runs.filter((run) => run.file === name);
    return { file: name, saved: file, hasDraft: drafted.includes(name), last: own[0] ?? null, runs: own.length };
  };
  const list = [...unsaved.map((name) => listed(name, null)), ...saved.map((file) => listed(file.name, file))];
  return list.sort((a, b) => lastUsed(b).localeCompare(lastUsed(a)) || a.file.localeCompare(b.file));
}

/// Whether a project fits the words of a search.
export function isFound({ file, last }: ListedProject, search: string): boolean {
  const text = `${file} ${last?.project ?? ''}`.toLowerCase();
  return search.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

const fileOf = (file: string) => file.slice(file.lastIndexOf('/') + 1);
/// A name in the folder of a file.
export const inFolderOf = (file: string, name: string) => file.slice(0, file.lastIndexOf('/') + 1) + name;
/// "slope copy.toml", numbered if that file exists.
export function copyName(file: string, taken: readonly string[]): string {
  const stem = fileOf(file).replace(/\.toml$/, '');
  for (let number = 1; ; ++number) {
    const name = `${stem} copy${number === 1 ? '' : ` ${number}`}.toml`;
    if (!taken.includes(inFolderOf(file, name))) return name;
  }
}
