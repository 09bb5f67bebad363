// Uses a file as the terrain: chosen, uploaded, or dropped on the page.

import { edit, file } from '../state/document';
import { notify, reportFailure } from '../state/messages';
import { chosen, sidePanel } from '../state/view';
import { uploadFiles } from './files';
import { tableAt } from './place';
import { changeTo, kindOf, terrainKinds } from './terrainKinds';
import type { KeyOf } from './names';

const endings: [RegExp, string, KeyOf<'terrain'>][] = [
  [/\.(tiff?|asc|vrt|img|dem)$/i, 'raster', 'raster'],
  [/\.(obj|stl|ply)$/i, 'mesh', 'mesh'],
  [/\.(csv|xyz|txt|pts|dat|las)$/i, 'survey', 'points'],
  [/\.dxf$/i, 'survey', 'lines'],
  [/\.(shp|gpkg|geojson)$/i, 'survey', 'lines'],
];
/// Files that may also be something else, such as areas of the ground or release points.
const isAmbiguous = /\.(shp|gpkg|geojson)$/i;

/// The kind of terrain and the key for a file, by its name; null if it cannot be a terrain.
export function terrainOfFile(name: string): { kind: string; key: KeyOf<'terrain'> } | null {
  const found = endings.find(([ending]) => ending.test(name));
  return found ? { kind: found[1], key: found[2] } : null;
}

/// The one of several files that is most likely a terrain.
export function terrainAmong(names: readonly string[]) {
  for (const [ending, kind, key] of endings) {
    const name = names.find((one) => ending.test(one));
    if (name !== undefined) return { name, kind, key };
  }
  return null;
}

/// Sets the terrain to a file, named as in the project.
export function useTerrainFile(name: string, kindName: string, key: KeyOf<'terrain'>) {
  const kind = terrainKinds.find((one) => one.name === kindName)!;
  const edits = changeTo(kind, tableAt(['terrain']), undefined);
  edit(`use ${name} as the terrain`, [...edits, { set: ['terrain', key] as const, value: name }]);
}

/// Uploads dropped files next to the project. One that can be a terrain becomes the terrain.
export async function takeFiles(list: readonly File[]) {
  const project = file.value;
  if (project === null) return;
  const uploaded = await uploadFiles(project, list);
  if (file.value !== project) return;
  const hasTerrain = kindOf(tableAt(['terrain'])) !== undefined;
  const taken = terrainAmong(hasTerrain ? uploaded.filter((name) => !isAmbiguous.test(name)) : uploaded);
  if (taken) {
    useTerrainFile(taken.name, taken.kind, taken.key);
    chosen.value = ['terrain'];
    sidePanel.value = 'model';
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
