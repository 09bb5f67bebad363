// A library of materials of one's own: a file of the folder, from which values are copied into projects. A project does
// not depend on the library afterwards.

import { signal } from '@preact/signals';
import { api, Refused } from '../api/client';
import { workplace } from '../state/about';
import { file } from './document';
import { nextRevision } from './drafts';
import { notify } from '../state/messages';
import { writeInTurn } from '../state/writes';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import type { TomlTable } from '../toml/format';
import type { Row } from '../settings/names';
import { readFolder } from './files';
import { unusedName } from './place';
import { isTable } from '../settings/tables';
import { append } from './things';

export const ownFile = 'own.materials.toml';

export interface OwnMaterial {
  name: string;
  /// The values, as keys of [[material]].
  values: Row<'material'>;
  /// The project that it was saved from, and the date.
  from: string;
  on: string;
}

export const ownMaterials = signal<OwnMaterial[]>([]);

const text = (value: unknown) => (typeof value === 'string' ? value : '');

function materialOf(row: TomlTable): OwnMaterial {
  const { name, saved_from, saved_on, ...values } = row;
  return { name: text(name), values: values as Row<'material'>, from: text(saved_from), on: text(saved_on) };
}

interface Stored {
  text: string;
  saved: string | null;
  rows: TomlTable[];
}

/// The file, if the folder has it. It is not asked for otherwise: browsers log what is not found as an error.
async function readFile(): Promise<{ text: string; saved: string | null }> {
  const none = { text: '', saved: null };
  const { files, more } = await readFolder();
  if (!more && !files.some(({ name }) => name === ownFile)) return none;
  try {
    return await api.project(ownFile);
  } catch (error) {
    if (!(error instanceof Refused) || error.status !== 404) throw error;
    return none;
  }
}

async function read(): Promise<Stored> {
  const stored = await readFile();
  const { material } = valuesOf(stored.text);
  return { ...stored, rows: Array.isArray(material) ? material.filter(isTable) : [] };
}

const take = (rows: readonly TomlTable[]) => (ownMaterials.value = rows.map(materialOf).filter(({ name }) => name !== ''));

export const loadOwn = async () => void take((await read()).rows);

/// Changes the library: `change` returns the new text. Another program's changes are kept, because it is read first.
const write = (change: (stored: Stored) => string) =>
  writeInTurn(async () => {
    const stored = await read();
    const next = change(stored);
    await api.saveProject(ownFile, { text: next, saved: stored.saved }, nextRevision(ownFile), workplace());
    const { material } = valuesOf(next);
    take(Array.isArray(material) ? material.filter(isTable) : []);
  });

const placeOf = (rows: readonly TomlTable[], name: string) => rows.findIndex((row) => row.name === name);

/// Saves a material of the project. One of the same name is replaced.
export async function saveOwn(material: Row<'material'>, name: string) {
  const value = { ...(material as TomlTable), name, saved_from: file.value ?? '', saved_on: new Date().toISOString().slice(0, 10) };
  await write(({ text: now, rows }) => {
    const at = placeOf(rows, name);
    const comment = now === '' ? 'Materials of one\'s own, for the workbench (talus serve), which copies them into projects.' : undefined;
    return edited(now, [...(at < 0 ? [] : [{ remove: ['material', at] }]), { append: ['material'], value, ...(comment && { comment }) }]);
  });
  notify('saved', `Saved ${name} in ${ownFile}`);
}

export const removeOwn = (name: string) =>
  write(({ text: now, rows }) => {
    const at = placeOf(rows, name);
    return at < 0 ? now : edited(now, [{ remove: ['material', at] }]);
  });

/// Copies a material into the project, with a comment on where it is from.
export function addOwn({ name, values, from, on }: OwnMaterial) {
  const source = `From ${ownFile}${from && `, saved there from ${from}`}${on && ` on ${on}`}`.replace(/[\p{Cc}]/gu, ' ');
  append('material', { ...values, name: unusedName('material', name) }, `add ${name}`, source);
}

/// Whether a material names a file, which other projects would not find.
export const namesFile = (material: Row<'material'>) =>
  Object.values(material).some((value) => isTable(value) && value.file !== undefined);
