// The projects of the folder, as the start page lists them, and what can be done with them.

import { signal } from '@preact/signals';
import { api } from '../api/client';
import type { DeletedProject, Example, Run } from '../api/types';
import { files, readFolder } from '../project/files';
import { storageKey, workplace } from '../state/about';
import { nextRevision } from '../project/drafts';
import { localDrafts } from '../project/localDrafts';
import { reportFailure } from '../state/messages';
import { allWritten, writeInTurn } from '../state/writes';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import { inFolderOf, listProjects, type ListedProject } from './projectList';
import { owned } from '../state/owned';

export const [examples, setExamples] = owned(signal<Example[]>([]));
/// The picture of an example, from docs/pictures.mjs.
export const examplePicture = (id: string) => `/examples/${id}.webp`;

export const drafts = signal<string[]>([]);
export const deleted = signal<DeletedProject[]>([]);

/// Reads the folder again.
export async function loadProjects() {
  await allWritten(); // including the draft of the project that was just closed
  const [folder, gone] = await Promise.all([readFolder(), api.deleted()]);
  drafts.value = folder.drafts;
  deleted.value = gone;
}

/// The picture of a project: that of its view when it was last closed, or else of the example that it is.
export function pictureOf({ file, saved }: ListedProject): string | null {
  if (saved?.picture) return api.pictureAddress(file, saved.picture);
  const example = examples.value.find((each) => each.file === file);
  return example ? examplePicture(example.id) : null;
}

export const projectsNow = (runs: readonly Run[]) =>
  listProjects(files.value, [...new Set([...drafts.value, ...localDrafts()])], runs);

/// What the browser stores for a project: settings of the view, drafts, the form of its study.
function moveStored(from: string, to: string) {
  const end = storageKey('', from);
  for (const key of Object.keys(localStorage)) {
    if (!key.endsWith(end)) continue;
    localStorage.setItem(key.slice(0, -end.length) + storageKey('', to), localStorage.getItem(key)!);
    localStorage.removeItem(key);
  }
}

/// Gives a project another name in its folder.
export async function renameProject(file: string, name: string) {
  const to = await writeInTurn(() => api.renameProject(file, name));
  moveStored(file, to);
  await loadProjects();
}

/// Copies a project, without its runs. Its title says so, unless its text cannot be read.
export async function duplicateProject(file: string, name: string) {
  const { text, saved, draft } = await api.project(file);
  const original = saved === null && draft ? draft.text : text;
  let copy = original;
  try {
    const title = valuesOf(original).name;
    if (typeof title === 'string') copy = edited(original, [{ set: ['name'], value: `${title} (copy)` }]);
  } catch {
    // It is not valid TOML, and is copied as it is.
  }
  const to = inFolderOf(file, name);
  await writeInTurn(() => api.saveProject(to, { text: copy, saved: null }, nextRevision(to), workplace()));
  await loadProjects();
}

export async function deleteProject(file: string) {
  await writeInTurn(() => api.deleteProject(file));
  await loadProjects();
}

const thenLoad = (task: () => Promise<unknown>) =>
  void writeInTurn(task)
    .catch(reportFailure)
    .then(loadProjects)
    .catch(reportFailure);
export const restoreProject = (id: string) => thenLoad(() => api.restore(id));
export const eraseProject = (id: string) => thenLoad(() => api.erase(id));
