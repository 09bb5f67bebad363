// The files of the folder, for settings that name one.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { FileKind, FolderFile } from '../api/types';
import { sayFailure } from '../state/messages';
import { lookAgain } from '../state/model';

export const files = signal<FolderFile[]>([]);

export async function loadFiles() {
  try {
    files.value = await api.files();
  } catch (error) {
    sayFailure(error);
  }
}

/// The kinds of file that a setting can name.
const kinds: Record<string, FileKind[]> = {
  mesh: ['mesh'],
  raster: ['raster'],
  mask: ['raster'],
  points: ['points', 'vector'],
  lines: ['vector'],
  boundary: ['vector'],
  polygons: ['vector'],
};

export function fittingFiles(key: string, list: readonly FolderFile[]): FolderFile[] {
  const wanted = kinds[key];
  return list.filter(({ kind }) => (wanted ? wanted.includes(kind) : kind !== 'project'));
}

const folderOf = (name: string) => name.split('/').slice(0, -1);

/// A file of the folder as a project names it: relative to its own place.
export function relativeTo(project: string, name: string): string {
  const [from, to] = [folderOf(project), name.split('/')];
  let shared = 0;
  while (shared < from.length && shared < to.length - 1 && from[shared] === to[shared]) ++shared;
  return [...Array<string>(from.length - shared).fill('..'), ...to.slice(shared)].join('/');
}

/// Keeps a file beside a project and gives the name by which the project may call it; null: the user would not have it
/// replaced.
export async function uploadBeside(project: string, content: File): Promise<string | null> {
  const name = [...folderOf(project), content.name].join('/');
  try {
    await api.upload(name, content);
  } catch (error) {
    if (!(error instanceof Refused) || error.status !== 409) throw error;
    if (!confirm(`There is a file ${name} already. Replace it?`)) return null;
    await api.upload(name, content, true);
  }
  await loadFiles();
  void lookAgain();
  return content.name;
}
