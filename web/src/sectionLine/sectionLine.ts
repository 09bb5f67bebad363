// The line on plan along which the ground is looked at, and what the engine says of the ground along it. The line is
// no part of the project: it stays while the model changes, and is asked for again.

import { batch, effect, signal } from '@preact/signals';
import { Refused, sendJson } from '../api/client';
import type { GroundSection, Point2, Point3 } from '../api/types';
import { draw } from '../model/drawing';
import { rounded } from '../model/plan';
import type { Waiting } from '../model/waitingRows';
import { showOverlay, tool, useTool, type Overlay } from '../scene/tool';
import { file } from '../state/document';
import { build, model } from '../state/model';
import { resultsOpen, resultsTab } from '../state/view';
import { piecesOf } from './groundSection';

/// Null: nobody asks for a section. With fewer than two places there is none yet.
export const sectionLine = signal<Point2[] | null>(null);
/// Places that are typed but not complete.
export const waitingPlaces = signal<readonly Waiting[]>([]);
/// Of the last line; while another is asked for, that of before.
export const groundSection = signal<GroundSection | null>(null);
export const refusal = signal<string | null>(null);
/// The place that is pointed at, by its number in the section.
export const marked = signal<number | null>(null);

const name = 'Section';
export const isDrawing = () => tool.value?.name === name;

export function drawSection() {
  sectionLine.value ??= [];
  resultsTab.value = 'section';
  const { min, max } = model.peek()!.bounds;
  const extent = Math.max(max[0] - min[0], max[1] - min[1]);
  draw({
    name,
    kind: 'line',
    least: 2,
    hint: 'Click along the line of the section.',
    done: (places) => {
      takeLine(places.map(([x, y]) => [rounded(x, extent), rounded(y, extent)]));
      resultsOpen.value = true;
    },
  });
}

export function takeLine(line: Point2[]) {
  sectionLine.value = line;
}

export function removeSection() {
  if (isDrawing()) useTool(null);
  waitingPlaces.value = [];
  sectionLine.value = null;
}

effect(() => {
  void file.value;
  waitingPlaces.value = [];
  sectionLine.value = null;
});

function forget() {
  batch(() => {
    groundSection.value = null;
    refusal.value = null;
    marked.value = null;
  });
}

async function ask(id: string, line: Point2[], signal: AbortSignal) {
  try {
    const answer = await sendJson<GroundSection>('POST', `/api/models/${id}/section`, { line }, signal);
    if (signal.aborted) return;
    batch(() => {
      groundSection.value = answer;
      refusal.value = null;
      marked.value = null;
    });
  } catch (error) {
    if (signal.aborted) return;
    // Forgotten by the server: built again, it has a section again.
    if (error instanceof Refused && error.status === 404) return void build();
    forget();
    refusal.value = error instanceof Error ? error.message : String(error);
  }
}

effect(() => {
  const [line, now] = [sectionLine.value, model.value];
  if (!line || line.length < 2 || now?.dimension !== 3) return forget();
  const asking = new AbortController();
  void ask(now.id, line, asking.signal);
  return () => asking.abort();
});

// In the scene: the line on the ground, and the place that is pointed at.
effect(() => {
  const section = groundSection.value;
  const lines = section ? piecesOf(section) : [];
  const ends = lines.flatMap((points) => [points[0]!, points.at(-1)!]);
  const drawn: Overlay[] = lines.map((points) => ({ points, kind: 'line', isBare: true }));
  showOverlay('section', ends.length > 0 ? [...drawn, { points: ends, kind: 'points' }] : []);
});
effect(() => {
  const [section, k] = [groundSection.value, marked.value];
  const z = section && k !== null ? section.z_m[k] : null;
  const place: Point3[] = typeof z === 'number' ? [[section!.x_m[k!]!, section!.y_m[k!]!, z]] : [];
  showOverlay('place in the section', place.length > 0 ? [{ points: place, kind: 'points' }] : []);
});
