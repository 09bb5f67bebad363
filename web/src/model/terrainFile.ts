// A file becomes the terrain: chosen, uploaded, or dropped on the page.

import { edit, file } from '../state/document';
import { say, sayFailure } from '../state/messages';
import { chosen, sidePanel } from '../state/view';
import { keepBeside } from './files';
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
/// Files that are as often something else: areas of the ground, places where rocks start.
const mayBeElse = /\.(shp|gpkg|geojson)$/i;

/// The kind and the key of the terrain that a file would be, by its name; null: none.
export function terrainOfFile(name: string): { kind: string; key: KeyOf<'terrain'> } | null {
  const found = endings.find(([ending]) => ending.test(name));
  return found ? { kind: found[1], key: found[2] } : null;
}

/// Of several files the one that is a terrain the most likely.
export function terrainAmong(names: readonly string[]) {
  for (const [ending, kind, key] of endings) {
    const name = names.find((one) => ending.test(one));
    if (name !== undefined) return { name, kind, key };
  }
  return null;
}

/// The terrain is this file from now on, called as the project calls it.
export function useTerrainFile(name: string, kindName: string, key: KeyOf<'terrain'>) {
  const kind = terrainKinds.find((one) => one.name === kindName)!;
  const edits = changeTo(kind, tableAt(['terrain']), undefined);
  edit(`take ${name} as the terrain`, [...edits, { set: ['terrain', key] as const, value: name }]);
}

/// Keeps dropped files beside the project; one that can be a terrain becomes it.
export async function takeFiles(list: readonly File[]) {
  const project = file.value;
  if (project === null) return;
  const kept = await keepBeside(project, list);
  if (file.value !== project) return;
  const hasTerrain = kindOf(tableAt(['terrain'])) !== undefined;
  const taken = terrainAmong(hasTerrain ? kept.filter((name) => !mayBeElse.test(name)) : kept);
  if (taken) {
    useTerrainFile(taken.name, taken.kind, taken.key);
    chosen.value = ['terrain'];
    sidePanel.value = 'model';
  } else if (kept.length > 0)
    say('note', `Kept in the folder: ${kept.join(', ')}. Forms that name a file offer it now.`);
}

/// Lets files be dropped anywhere on the page.
export function listenToDrops(take: (list: File[]) => Promise<void>): () => void {
  const over = (event: DragEvent) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  };
  const drop = (event: DragEvent) => {
    const list = [...(event.dataTransfer?.files ?? [])];
    if (list.length === 0) return;
    event.preventDefault();
    void take(list).catch(sayFailure);
  };
  addEventListener('dragover', over);
  addEventListener('drop', drop);
  return () => {
    removeEventListener('dragover', over);
    removeEventListener('drop', drop);
  };
}
