// Lines and areas from files.

import { getJson } from '../api/client';
import type { Point2, Problem } from '../api/types';
import { isPointText } from '../settings/fileEndings';
import { files, fittingName, inFolder, uploadFiles } from '../project/files';
import { file } from '../project/document';
import { notify, resolve } from '../state/messages';
import { model } from '../project/model';
import { counted } from '../units/numbers';
import { ask, openCard } from './asked';
import { pointsOfText } from './textLine';

interface ReadShape {
  kind: 'line' | 'polygon';
  points: Point2[];
}

async function takeText(of: File) {
  const points = pointsOfText(await of.text());
  if (!points)
    return notify('error', `${of.name} has no line: it needs two or more rows, with x and y in metres in the first two columns.`, 'asked file');
  resolve('asked file');
  openCard();
  ask({ kind: 'line', points }, `ask ${of.name}`);
}

/// Asks the line through the points of a text, or the first line or area of a vector file, which is stored beside the
/// project.
export async function takeLineFiles(list: readonly File[]) {
  const project = file.value;
  const [first] = list;
  if (project === null || !first) return;
  if (isPointText(first.name)) return takeText(first);
  const uploaded = await uploadFiles(project, list);
  const [name, now] = [fittingName('lines', uploaded, files.value), model.value];
  if (name === undefined || file.value !== project || !now) return;
  const address = `/api/models/${now.id}/lines?file=${encodeURIComponent(inFolder(name))}`;
  const { shapes, problems } = await getJson<{ shapes: ReadShape[]; problems: Problem[] }>(address);
  if (file.value !== project) return;
  for (const problem of problems) notify('note', problem.text);
  const [shape] = shapes;
  if (!shape) return;
  openCard();
  ask({ kind: shape.kind, points: shape.points }, `ask ${name}`);
  if (shapes.length > 1) notify('note', `${name} has ${counted(shapes.length, 'line')}; the first one is asked.`);
}
