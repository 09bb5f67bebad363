// The files of the folder, for settings that name a file.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import type { FileKind, FolderFile } from '../api/types';
import { reportFailure } from '../state/messages';
import { file } from './document';
import { rebuild } from './model';
import type { Name } from '../settings/names';
import { askToReplace } from './replacing';

export const files = signal<FolderFile[]>([]);
/// Whether the folder has more files than are listed.
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
    reportFailure(error);
  }
}

/// The kinds of files that a setting accepts.
const kinds: Partial<Record<Name, FileKind[]>> = {
  mesh: ['mesh'],
  raster: ['raster'],
  mask: ['raster'],
  section: ['points', 'vector'],
  points: ['points', 'vector'],
  lines: ['vector'],
  boundary: ['vector'],
  polygons: ['vector'],
  table: ['points', 'vector'],
  file: ['points'],
};

const kindsOfLayers: FileKind[] = ['raster', 'picture', 'vector'];

export function fittingFiles(key: Name, list: readonly FolderFile[], table = ''): FolderFile[] {
  const wanted = table === 'layer' ? kindsOfLayers : kinds[key];
  return list.filter(({ kind }) => (wanted ? wanted.includes(kind) : kind !== 'project' && kind !== 'materials'));
}

/// The chosen files of an input. Clears the input, so that the same files can be chosen again.
export function chosenFiles(input: HTMLInputElement): File[] {
  const list = [...(input.files ?? [])];
  input.value = '';
  return list;
}

const folderOf = (name: string) => name.split('/').slice(0, -1);

/// The name of a file relative to the project's folder.
export function relativeTo(project: string, name: string): string {
  const [from, to] = [folderOf(project), name.split('/')];
  let shared = 0;
  while (shared < from.length && shared < to.length - 1 && from[shared] === to[shared]) ++shared;
  return [...Array<string>(from.length - shared).fill('..'), ...to.slice(shared)].join('/');
}

/// A file named in the open project, as the server names it.
export const inFolder = (name: string): string => {
  const parts = [...folderOf(file.value ?? ''), ...name.split('/')];
  return parts.reduce<string[]>((path, part) => (part === '..' ? path.slice(0, -1) : [...path, part]), []).join('/');
};

/// Uploads a file next to a project and returns its name, or the name of an existing file that the user prefers; null if
/// the user cancels.
async function uploadBeside(project: string, content: File): Promise<string | null> {
  const name = [...folderOf(project), content.name].join('/');
  await loadFiles(); // ask before uploading, as the file may be large
  const exists = files.value.some((one) => one.name === name);
  const choice = exists ? await askToReplace(name) : 'replace';
  if (choice === 'cancel') return null;
  if (choice === 'use the existing file') return content.name;
  try {
    await api.upload(name, content, exists);
  } catch (error) {
    if (!(error instanceof Refused) || error.status !== 409) throw error;
    const answer = await askToReplace(name);
    if (answer === 'cancel') return null;
    if (answer === 'replace') await api.upload(name, content, true);
  }
  await loadFiles();
  void rebuild();
  return content.name;
}

/// Uploads files next to a project and returns their names there.
export async function uploadFiles(project: string, list: readonly File[]): Promise<string[]> {
  const names: string[] = [];
  for (const one of list) {
    const name = await uploadBeside(project, one);
    if (name !== null) names.push(name);
  }
  return names;
}

/// The one of several uploaded files that a setting names: the .shp of a Shapefile, not its .dbf.
export function fittingName(key: Name, names: readonly string[], list: readonly FolderFile[], table = ''): string | undefined {
  const fitting = new Set(fittingFiles(key, list, table).map(({ name }) => name.split('/').at(-1)));
  return names.find((name) => fitting.has(name)) ?? names[0];
}
