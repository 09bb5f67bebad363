// Takes a line from the map: the one of a reference layer that is clicked, or the contour through a place.

import { Refused, sendJson } from '../api/client';
import type { Point2, Point3 } from '../api/types';
import { addressOf, isDrawn, projectLayers } from '../layers/layers';
import { lengthOf } from '../geometry/plan';
import { draw } from '../tools/drawing';
import { dimension } from '../project/place';
import { sceneCamera } from '../view/sceneCamera';
import { tool, useTool } from '../tools/tool';
import { notify, reportFailure, resolve } from '../state/messages';
import { model } from '../project/model';
import { numberText } from '../units/numbers';
import { ask, openCard } from './asked';

const names = { layer: 'Take a line of a layer', contour: 'Take a contour' } as const;
export const isTaking = (what: keyof typeof names) => tool.value?.name === names[what];

/// The layers whose lines can be taken.
export const vectorLayers = () => projectLayers.value.filter((layer) => layer.found?.kind === 'vector' && isDrawn(layer));

interface Nearest {
  shape: { kind: 'line' | 'polygon'; name: string; distance_m: number; points: Point2[] } | null;
}

const reach = 12; // pixels

async function takeNearest([x, y]: Point3) {
  const now = model.peek();
  const reach_m = reach * sceneCamera.peek().metresPerPixel;
  const found = await Promise.all(vectorLayers().map((layer) => sendJson<Nearest>('POST', addressOf(layer, 'nearest'), { place: [x, y], reach_m })));
  if (model.peek()?.id !== now?.id) return;
  const [best] = found.flatMap(({ shape }) => shape ?? []).sort((a, b) => a.distance_m - b.distance_m);
  if (!best) return notify('note', 'There is no line of a layer where you clicked.', 'asked file');
  resolve('asked file');
  // The outline of an area ends where it begins.
  const points = best.kind === 'polygon' ? best.points.slice(0, -1) : best.points;
  ask({ kind: best.kind, points }, `ask ${best.name || 'a line of a layer'}`);
}

export interface Contour {
  elevation_m: number;
  points: Point2[];
}

const contourOf = (id: string, [x, y]: Point3, elevation_m?: number) =>
  sendJson<Contour>('POST', `/api/models/${id}/contour`, { place: [x, y], ...(elevation_m !== undefined && { elevation_m }) });

const askIt = ({ elevation_m, points }: Contour, opens: boolean) =>
  ask({ kind: 'line', points }, `ask the contour at ${numberText(elevation_m, 5)} m`, opens);

/// Asks the contour through a place, or at an elevation near it.
export async function askContour(place: Point3, elevation_m?: number) {
  const now = model.peek();
  if (!now) return;
  try {
    const found = await contourOf(now.id, place, elevation_m);
    if (model.peek()?.id !== now.id) return;
    resolve('asked file');
    askIt(found, true);
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    notify('note', error.message, 'asked file');
  }
}

/// Asks the first of the contours through these places that is `wanted_m` long on plan, or else the longest, without
/// opening the card.
export async function askLongContour(places: readonly Point3[], wanted_m: number) {
  const now = model.peek();
  if (!now) return;
  let [best, longest]: [Contour | null, number] = [null, -1];
  for (const place of places) {
    if (longest >= wanted_m) break;
    try {
      const found = await contourOf(now.id, place);
      const length = lengthOf(found.points);
      if (length > longest) [best, longest] = [found, length];
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
    }
  }
  if (model.peek()?.id !== now.id) return;
  if (best) askIt(best, false);
  else notify('note', 'No contour runs through the places where rocks stop.', 'asked file');
}

export function takeFromMap(what: keyof typeof names, elevation?: () => number | undefined) {
  openCard();
  if (isTaking(what)) return useTool(null);
  if (dimension.peek() === 2) return;
  draw({
    name: names[what],
    kind: 'points',
    least: 1,
    most: 1,
    hint: what === 'layer' ? 'Click a line of a reference layer.' : 'Click the place through which the contour runs, or near which it has the elevation of the card.',
    done: ([place]) => void (what === 'layer' ? takeNearest(place!) : askContour(place!, elevation?.())).catch(reportFailure),
  });
}
