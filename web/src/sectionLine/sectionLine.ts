// The line of the ground section on plan, and the ground along it from the engine. The line is not part of the project: it
// stays when the model changes, and the section is computed again.

import { batch, effect, signal } from '@preact/signals';
import { Refused, sendJson } from '../api/client';
import type { GroundSection, Point2, Point3 } from '../api/types';
import { draw } from '../tools/drawing';
import { rounded } from '../geometry/plan';
import type { Waiting } from '../settings/waitingRows';
import { showOverlay, tool, useTool, type Overlay } from '../tools/tool';
import { file } from '../project/document';
import { build, model } from '../project/model';
import { openResults, showTab } from '../state/panels';
import { piecesOf } from './groundSection';
import { owned } from '../state/owned';

/// Null: no section is requested. With fewer than two points it is not complete yet.
export const sectionLine = signal<Point2[] | null>(null);
/// Incomplete rows of points.
export const [waitingRows, keepRows] = owned(signal<readonly Waiting[]>([]));
/// The last section, also while the next one is loading.
export const groundSection = signal<GroundSection | null>(null);
/// The error if the section could not be computed.
export const refusal = signal<string | null>(null);
/// The index of the highlighted point of the section.
export const [marked, mark] = owned(signal<number | null>(null));

const name = 'Section';
export const isDrawing = () => tool.value?.name === name;

export function drawSection() {
  sectionLine.value ??= [];
  showTab('section');
  const { min, max } = model.peek()!.bounds;
  const extent = Math.max(max[0] - min[0], max[1] - min[1]);
  draw({
    name,
    kind: 'line',
    least: 2,
    hint: 'Click along the line of the section.',
    done: (places) => {
      takeLine(places.map(([x, y]) => [rounded(x, extent), rounded(y, extent)]));
      openResults();
    },
  });
}

export function takeLine(line: Point2[]) {
  sectionLine.value = line;
}

export function removeSection() {
  if (isDrawing()) useTool(null);
  keepRows([]);
  sectionLine.value = null;
}

effect(() => {
  void file.value;
  keepRows([]);
  sectionLine.value = null;
});

function forget() {
  batch(() => {
    groundSection.value = null;
    refusal.value = null;
    mark(null);
  });
}

async function ask(id: string, line: Point2[], signal: AbortSignal) {
  try {
    const answer = await sendJson<GroundSection>('POST', `/api/models/${id}/section`, { line }, signal);
    if (signal.aborted) return;
    batch(() => {
      groundSection.value = answer;
      refusal.value = null;
      mark(null);
    });
  } catch (error) {
    if (signal.aborted) return;
    // The server no longer has the model: build it again.
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

// Shows the line on the ground and the highlighted point in the scene.
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
