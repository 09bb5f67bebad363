// Files of a GIS that were dropped on the page: stored beside the project, and then asked what they are.

import { signal } from '@preact/signals';
import { ask } from '../askLine/asked';
import { getJson, Refused } from '../api/client';
import type { Problem } from '../api/types';
import { fileFormats } from '../generated/schema';
import { changeWay, groundWays } from '../model/groundWays';
import { files, fittingName, uploadFiles } from '../model/files';
import type { FileKind } from '../model/fileEndings';
import { materialNames } from '../model/form/references';
import type { Edit, TableName } from '../model/names';
import { nameOf, tableAt } from '../model/place';
import { takeTerrain, terrainOfFile, useTerrainFile } from '../model/terrainFile';
import { inFolder } from '../calibration/observations';
import { edit, file, rowsOf } from '../state/document';
import { ofProject } from '../state/ofProject';
import { model } from '../state/model';
import { chosen, isAsking, sidePanel } from '../state/view';
import { unpacked } from './unzip';
import { barrierEdits, layerEdits, releaseEdits, type ReadShape, type Use } from './uses';

export interface Dropped {
  name: string;
  kind: FileKind;
  /// The lines and areas of a vector file; null while they are read, if there are none, and for rasters.
  shapes: ReadShape[] | null;
  isReading: boolean;
  /// What the server says about the file: no coordinate system, several layers ...
  problems: Problem[];
}
/// The file that the dialog asks about.
export const dropped = ofProject<Dropped | null>(null);
const reading = signal(0);

const kindOf = (name: string): FileKind | null => fileFormats.find(({ ending }) => name.toLowerCase().endsWith(ending))?.kind ?? null;

/// Whether one of the files is a raster or a picture.
export const hasRaster = (list: readonly File[]) => list.some(({ name }) => ['raster', 'picture'].includes(kindOf(name) ?? ''));

/// Whether a file of this name is asked about: a file of a GIS that is not the present terrain.
function isAskedAbout(name: string): boolean {
  const kind = kindOf(name);
  const terrain = Object.values(tableAt(['terrain'])).flat();
  return (kind === 'raster' || kind === 'picture' || kind === 'vector') && !terrain.includes(name);
}

/// Stores dropped files beside the project. Without a terrain, one that can be the terrain becomes it; with one, the page
/// asks what a file of a GIS is.
export async function takeDropped(list: readonly File[]) {
  const project = file.value;
  if (project === null) return;
  const uploaded = await uploadFiles(project, await unpacked(list));
  if (file.value !== project || uploaded.length === 0) return;
  const name = fittingName('file', uploaded, files.value, 'layer');
  const now = model.value;
  if (name === undefined || !now || now.dimension === 2 || !isAskedAbout(name)) return takeTerrain(uploaded);
  const kind = kindOf(name)!;
  const isVector = kind === 'vector';
  const own = (reading.value = reading.peek() + 1);
  dropped.value = { name, kind, shapes: null, isReading: isVector, problems: [] };
  if (!isVector) return;
  const found = await getJson<{ shapes: ReadShape[]; problems: Problem[] }>(`/api/models/${now.id}/lines?file=${encodeURIComponent(inFolder(name))}`).catch(
    (error: unknown) => {
      if (error instanceof Refused) return { shapes: null, problems: error.problems };
      throw error;
    },
  );
  if (reading.peek() === own && dropped.peek()?.name === name) dropped.value = { name, kind, ...found, isReading: false };
}

const namesIn = (...keys: TableName[]) => keys.flatMap((key) => rowsOf(key).map((_, index) => nameOf(key, index)));

function put(key: TableName, what: string, edits: readonly Edit[]) {
  const index = rowsOf(key).length;
  if (!edit(what, edits)) return;
  chosen.value = [key, index];
  sidePanel.value = 'model';
}

/// Puts the file into the project as the user chose, as one step of Undo.
export function useDropped({ name, shapes }: Dropped, use: Use) {
  dropped.value = null;
  switch (use) {
    case 'layer':
      return put('layer', `add the layer ${name}`, layerEdits(name, namesIn('layer')));
    case 'barrier':
    case 'collector':
      return put(use, `add the ${use}s of ${name}`, barrierEdits(use, name, shapes ?? [], namesIn('barrier', 'collector')));
    case 'release':
      return put('seeder', `add the releases of ${name}`, releaseEdits(name, shapes ?? [], namesIn('seeder')));
    case 'ground': {
      const way = groundWays.find((each) => each.name === 'polygons')!;
      const edits = [...changeWay(way, tableAt(['ground']), materialNames()), { set: ['ground', 'polygons'] as const, value: name }];
      if (edit(`use ${name} for the ground`, edits)) [chosen.value, sidePanel.value] = [['ground'], 'model'];
      return;
    }
    case 'ask': {
      const shape = shapes?.find(({ kind }) => kind === 'line') ?? shapes?.[0];
      if (!shape) return;
      isAsking.value = true;
      return ask({ kind: shape.kind, points: shape.points }, `ask ${name}`);
    }
    case 'terrain': {
      const terrain = terrainOfFile(name);
      if (!terrain) return;
      useTerrainFile(name, terrain.kind, terrain.key);
      [chosen.value, sidePanel.value] = [['terrain'], 'model'];
      return;
    }
    case 'store':
  }
}
