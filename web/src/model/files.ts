// The files of the folder, for settings that name one.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { FileKind, FolderFile } from '../api/types';
import { sayFailure } from '../state/messages';
import { lookAgain } from '../state/model';
import type { Name } from './names';
import { askToReplace } from './replacing';

export const files = signal<FolderFile[]>([]);
/// Whether the folder has others, which are not listed.
export const hasMoreFiles = signal(false);

export async function readFolder() {
  const folder = await api.folder();
  files.value = folder.files;
  hasMoreFiles.value = folder.more;
  return folder;
}

export async function loadFiles() {
  try {
    await readFolder();
  } catch (error) {
    sayFailure(error);
  }
}

/// The kinds of file that a setting can name.
const kinds: Partial<Record<Name, FileKind[]>> = {
  mesh: ['mesh'],
  raster: ['raster'],
  mask: ['raster'],
  points: ['points', 'vector'],
  lines: ['vector'],
  boundary: ['vector'],
  polygons: ['vector'],
};

export function fittingFiles(key: Name, list: readonly FolderFile[]): FolderFile[] {
  const wanted = kinds[key];
  return list.filter(({ kind }) => (wanted ? wanted.includes(kind) : kind !== 'project'));
}

/// The files that were chosen in a field, which may choose the same ones again.
export function chosenFiles(input: HTMLInputElement): File[] {
  const list = [...(input.files ?? [])];
  input.value = '';
  return list;
}

const folderOf = (name: string) => name.split('/').slice(0, -1);

/// A file of the folder as a project names it: relative to its own place.
export function relativeTo(project: string, name: string): string {
  const [from, to] = [folderOf(project), name.split('/')];
  let shared = 0;
  while (shared < from.length && shared < to.length - 1 && from[shared] === to[shared]) ++shared;
  return [...Array<string>(from.length - shared).fill('..'), ...to.slice(shared)].join('/');
}

/// Keeps a file beside a project and gives the name by which the project may call it, also where the user takes the one
/// that is there already; null: neither.
async function uploadBeside(project: string, content: File): Promise<string | null> {
  const name = [...folderOf(project), content.name].join('/');
  await loadFiles(); // asked before it is sent: it may be large
  const isThere = files.value.some((one) => one.name === name);
  const asked = isThere ? await askToReplace(name) : 'replace';
  if (asked === 'neither') return null;
  if (asked === 'take what is there') return content.name;
  try {
    await api.upload(name, content, isThere);
  } catch (error) {
    if (!(error instanceof Refused) || error.status !== 409) throw error;
    const answer = await askToReplace(name);
    if (answer === 'neither') return null;
    if (answer === 'replace') await api.upload(name, content, true);
  }
  await loadFiles();
  void lookAgain();
  return content.name;
}

/// Keeps files beside a project, and gives their names there.
export async function keepBeside(project: string, list: readonly File[]): Promise<string[]> {
  const names: string[] = [];
  for (const one of list) {
    const name = await uploadBeside(project, one);
    if (name !== null) names.push(name);
  }
  return names;
}

/// Of files that were chosen together the one that a setting names: not what goes along, such as the .dbf of a Shapefile.
export function fittingName(key: Name, names: readonly string[], list: readonly FolderFile[]): string | undefined {
  const fitting = new Set(fittingFiles(key, list).map(({ name }) => name.split('/').at(-1)));
  return names.find((name) => fitting.has(name)) ?? names[0];
}
