// Uses a file as the terrain: chosen, uploaded, or dropped on the page.

import { edit } from './document';
import { notify, reportFailure } from '../state/messages';
import { openForm } from './chosen';
import { fileFormats } from '../generated/schema';
import type { FileKind } from '../settings/fileEndings';
import { tableAt } from './place';
import { changeTo, terrainKinds } from '../settings/terrainKinds';
import type { KeyOf } from '../settings/names';

/// What a file can be, the likeliest terrain first: the kind and the key of the terrain. A vector file is as often
/// something else, an area of the ground or a place where rocks start; a drawing is not.
const terrains: Record<Exclude<FileKind, 'picture'> | 'drawing', { kind: string; key: KeyOf<'terrain'> }> = {
  raster: { kind: 'raster', key: 'raster' },
  mesh: { kind: 'mesh', key: 'mesh' },
  points: { kind: 'survey', key: 'points' },
  drawing: { kind: 'survey', key: 'lines' },
  vector: { kind: 'survey', key: 'lines' },
};

function kindOfFile(name: string): keyof typeof terrains | null {
  const format = fileFormats.find(({ ending }) => name.toLowerCase().endsWith(ending));
  if (format?.ending === '.dxf') return 'drawing';
  return !format || format.kind === 'picture' ? null : format.kind;
}

/// The kind of terrain and the key for a file, by its name; null if it cannot be a terrain.
export function terrainOfFile(name: string): { kind: string; key: KeyOf<'terrain'> } | null {
  const kind = kindOfFile(name);
  return kind && terrains[kind];
}

/// The one of several files that is most likely a terrain.
export function terrainAmong(names: readonly string[]) {
  for (const kind of Object.keys(terrains)) {
    const name = names.find((one) => kindOfFile(one) === kind);
    if (name !== undefined) return { name, ...terrains[kind as keyof typeof terrains] };
  }
  return null;
}

/// Sets the terrain to a file, named as in the project.
export function useTerrainFile(name: string, kindName: string, key: KeyOf<'terrain'>) {
  const kind = terrainKinds.find((one) => one.name === kindName)!;
  const edits = changeTo(kind, tableAt(['terrain']), undefined);
  edit(`use ${name} as the terrain`, [...edits, { set: ['terrain', key] as const, value: name }]);
}

/// Whether the present terrain is of this file, named as in the project.
export const isOfTerrain = (name: string) => Object.values(tableAt(['terrain'])).flat().includes(name);

/// The one of uploaded files that can be a terrain becomes the terrain, if it is not yet.
export function takeTerrain(uploaded: readonly string[]) {
  const taken = terrainAmong(uploaded.filter((name) => !isOfTerrain(name)));
  if (taken) {
    useTerrainFile(taken.name, taken.kind, taken.key);
    openForm(['terrain']);
  } else if (uploaded.length > 0)
    notify('note', `Uploaded: ${uploaded.join(', ')}. Forms for files now offer ${uploaded.length === 1 ? 'it' : 'them'}.`);
}

/// Accepts files dropped anywhere on the page.
export function listenToDrops(take: (list: File[]) => Promise<void>): () => void {
  const over = (event: DragEvent) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  };
  const drop = (event: DragEvent) => {
    const list = [...(event.dataTransfer?.files ?? [])];
    if (list.length === 0) return;
    event.preventDefault();
    void take(list).catch(reportFailure);
  };
  addEventListener('dragover', over);
  addEventListener('drop', drop);
  return () => {
    removeEventListener('dragover', over);
    removeEventListener('drop', drop);
  };
}
