// Files that were dropped on the page or imported: stored beside the project, and then asked what they are.

import { ask, openCard } from '../askLine/asked';
import { getJson, Refused } from '../api/client';
import type { Problem } from '../api/types';
import { fileFormats } from '../generated/schema';
import { changeWay, groundWays } from '../settings/groundWays';
import { inFolder, uploadFiles } from '../project/files';
import { isPointText, type FileKind } from '../settings/fileEndings';
import { materialNames, is2d, nameOf, tableAt } from '../project/place';
import type { Edit, TableName } from '../settings/names';
import { isOfTerrain, takeTerrain, terrainAmong, terrainOfFile, useTerrainFile } from '../project/terrainFile';
import { kindOf } from '../settings/terrainKinds';
import { sectionEdits } from '../settings/sectionFile';
import { edit, file, rowsOf } from '../project/document';
import { ofProject } from '../project/ofProject';
import { modelNow } from '../project/model';
import { openForm } from '../project/chosen';
import { unpacked } from './unzip';
import { triedAs, triedBoth } from './triedTerrain';
import { barrierEdits, choicesFor, forestEdits, layerEdits, refusals, releaseEdits, terrainChoices, type Choice, type ReadShape, type Use } from './uses';
import { owned } from '../state/owned';

export interface Dropped {
  name: string;
  kind: FileKind;
  /// The lines and areas of a vector file; null while they are read, if there are none, and for rasters.
  shapes: ReadShape[] | null;
  isReading: boolean;
  choices: Choice[]; // none while it is read
  /// What the server says about the file: no coordinate system, several layers ...
  problems: Problem[];
}
/// The file that the dialog asks about.
export const [dropped, setDropped] = owned(ofProject<Dropped | null>(null));

const fileKind = (name: string): FileKind | null => fileFormats.find(({ ending }) => name.toLowerCase().endsWith(ending))?.kind ?? null;

/// Whether one of the files is a raster or a picture.
export const hasRaster = (list: readonly File[]) => list.some(({ name }) => ['raster', 'picture'].includes(fileKind(name) ?? ''));

/// Whether a file of this name can be a section as well as a survey.
export const isTableOrLines = (name: string) => isPointText(name) || fileKind(name) === 'vector';

const hasTerrain = () => kindOf(tableAt(['terrain'])) !== undefined;
const isInSpace = () => hasTerrain() && !is2d.value;
const canBeLayer = (name: string) => ['raster', 'picture', 'vector'].includes(fileKind(name) ?? '');

/// The one of stored files that is asked about: one of a GIS beside a terrain in 3D, otherwise the likeliest terrain; not
/// the present one. Whatever would replace a terrain is asked about.
function askedAmong(stored: readonly string[]): string | undefined {
  const names = stored.filter((name) => !isOfTerrain(name));
  const name = (isInSpace() ? names.find(canBeLayer) : undefined) ?? terrainAmong(names)?.name;
  return name !== undefined && (hasTerrain() || isTableOrLines(name)) ? name : undefined;
}

/// Stores files beside the project, and takes them.
export async function takeDropped(list: readonly File[]) {
  const project = file.value;
  if (project === null) return;
  const uploaded = await uploadFiles(project, await unpacked(list));
  if (file.value === project && uploaded.length > 0) await takeStored(uploaded);
}

/// The page asks what files beside the project are. Without a terrain, one that can only be the terrain becomes it.
export async function takeStored(names: readonly string[]) {
  const name = askedAmong(names);
  if (name === undefined) return takeTerrain(names);
  const kind = fileKind(name)!;
  const asked: Dropped = { name, kind, shapes: null, isReading: true, choices: [], problems: [] };
  setDropped(asked);
  try {
    const found = await readAs(name, kind);
    if (dropped.peek() !== asked) return;
    const canBe = (wanted: Use) => found.choices.some(({ use }) => use === wanted);
    if (!hasTerrain() && canBe('terrain') && !canBe('section')) return useDropped({ ...asked, ...found }, 'terrain');
    setDropped({ ...asked, ...found, isReading: false });
  } catch (error) {
    if (dropped.peek() === asked) setDropped(null);
    throw error;
  }
}

/// What a file can be, and what the server says about it.
async function readAs(name: string, kind: FileKind): Promise<Pick<Dropped, 'shapes' | 'choices' | 'problems'>> {
  const project = file.value!;
  if (!isTableOrLines(name)) return { shapes: null, choices: choicesFor(kind, null, { isInSpace: isInSpace() }), problems: [] };
  const model = kind === 'vector' && isInSpace() ? await modelNow() : null;
  if (!model) {
    const tried = await triedBoth(name, project, terrainOfFile(name)!.key);
    return { shapes: null, choices: terrainChoices(kind, tried), problems: refusals(tried) };
  }
  const lines = `/api/models/${model.id}/lines?file=${encodeURIComponent(inFolder(name))}`;
  const read = getJson<{ shapes: ReadShape[]; problems: Problem[] }>(lines).catch((error: unknown) => {
    if (error instanceof Refused) return { shapes: null, problems: error.problems };
    throw error;
  });
  const [{ shapes, problems }, section] = await Promise.all([read, triedAs('section', name, project)]);
  return { shapes, problems, choices: choicesFor(kind, shapes, { isSection: 'terrain' in section }) };
}

const namesIn = (...keys: TableName[]) => keys.flatMap((key) => rowsOf(key).map((_, index) => nameOf(key, index)));

function put(key: TableName, what: string, edits: readonly Edit[]) {
  const index = rowsOf(key).length;
  if (!edit(what, edits)) return;
  openForm([key, index]);
}

/// Puts the file into the project as the user chose, as one step of Undo.
export function useDropped({ name, shapes }: Dropped, use: Use) {
  setDropped(null);
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
      if (edit(`use ${name} for the ground`, edits)) openForm(['ground']);
      return;
    }
    case 'forest':
      return put('forest', `add the forest of ${name}`, forestEdits(name, namesIn('forest')));
    case 'ask': {
      const shape = shapes?.find(({ kind }) => kind === 'line') ?? shapes?.[0];
      if (!shape) return;
      openCard();
      return ask({ kind: shape.kind, points: shape.points }, `ask ${name}`);
    }
    case 'section': {
      if (edit(`use ${name} as the section`, sectionEdits(name, tableAt(['terrain'])))) openForm(['terrain']);
      return;
    }
    case 'terrain': {
      const terrain = terrainOfFile(name);
      if (!terrain) return;
      useTerrainFile(name, terrain.kind, terrain.key);
      openForm(['terrain']);
      return;
    }
    case 'store':
  }
}
