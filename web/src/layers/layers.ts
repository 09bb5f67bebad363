// The reference layers of the model as the views show them: what the server found in their files, and the settings of the
// view, which the browser keeps beside those of the project.

import { computed, effect, signal } from '@preact/signals';
import { getJson, Refused } from '../api/client';
import type { Point2, Problem } from '../api/types';
import { model, setLayerProblems } from '../project/model';
import { keptOfProject } from '../project/ofProject';
import type { LegendData } from '../view/legends';
import { ownOf, withOwn, type OwnSettings } from './own';

export interface LayerRow {
  name: string;
  file: string;
  colour: string;
  opacity: number;
  visible: boolean;
}

export interface FoundRaster {
  kind: 'raster';
  /// Changes with the picture.
  key: string;
  /// The south-west and the north-east corner.
  area: [Point2, Point2];
  columns: number;
  rows: number;
  /// Of measured values; null: the picture has its own colours.
  ramp: { least: number; most: number; colours: string[] } | null;
  problems: Problem[];
}
export interface FoundVectors {
  kind: 'vector';
  key: string;
  shapes: number;
  problems: Problem[];
}
export interface Layer extends LayerRow {
  /// Its entry in the project.
  index: number;
  /// Null while the file is being read, and if it cannot be.
  found: FoundRaster | FoundVectors | null;
  problems: Problem[];
}

const kept = keptOfProject<string>('layers', '');
export const changeLayer = (name: string, change: Partial<OwnSettings>) => (kept.value = withOwn(kept.peek(), name, change));

type Answer = { found: FoundRaster | FoundVectors } | { refused: Problem[] };
const answers = signal<{ model: string; of: (Answer | undefined)[] }>({ model: '', of: [] });

/// The layers of the project, the lowest first; none in 2D.
export const projectLayers = computed<Layer[]>(() => {
  const now = model.value;
  if (!now || now.dimension === 2) return [];
  const own = ownOf(kept.value);
  return ((now.project.layer ?? []) as LayerRow[]).map((row, index) => {
    const answer = answers.value.of[index];
    const found = answer && 'found' in answer ? answer.found : null;
    const problems = answer && 'refused' in answer ? answer.refused : (found?.problems ?? []);
    return { ...row, ...own[row.name], index, found, problems };
  });
});

const problemOf = (error: unknown): Problem[] =>
  error instanceof Refused ? error.problems : [{ severity: 'error', text: String(error) } as Problem];

let asking: AbortController | undefined;
effect(() => {
  const now = model.value;
  asking?.abort();
  const rows = now && now.dimension === 3 ? ((now.project.layer ?? []) as LayerRow[]) : [];
  if (!now || rows.length === 0) {
    answers.value = { model: '', of: [] };
    return;
  }
  const own = (asking = new AbortController());
  // Layers that stay keep their picture until the answer arrives.
  const before = answers.peek().of;
  const next: (Answer | undefined)[] = rows.map((_, index) => before[index]);
  answers.value = { model: now.id, of: next.slice() };
  rows.forEach((_, index) => {
    getJson<FoundRaster | FoundVectors>(`/api/models/${now.id}/layers/${index}`, own.signal).then(
      (found) => ({ found }),
      (error: unknown) => ({ refused: problemOf(error) }),
    ).then((answer: Answer) => {
      if (own.signal.aborted) return;
      next[index] = answer;
      answers.value = { model: now.id, of: next.slice() };
    });
  });
});

effect(() => {
  setLayerProblems(projectLayers.value.flatMap(({ problems }) => problems.map((problem) => ({ ...problem, severity: 'warning' as const }))));
});

/// The address of what a layer is drawn from, at the server.
export function addressOf(layer: Layer, what: 'picture' | 'lines' | 'nearest'): string {
  return `/api/models/${answers.peek().model}/layers/${layer.index}/${what}`;
}

export const isDrawn = ({ visible, opacity, found }: Layer) => visible && opacity > 0 && found !== null;

/// Scales of colours of the layers with measured values, and the colours of lines.
export function layerLegends(): LegendData[] {
  const drawn = projectLayers.value.filter(isDrawn);
  const scales = drawn.flatMap(({ name, found }): LegendData[] => {
    if (found?.kind !== 'raster' || !found.ramp) return [];
    const { least, most, colours } = found.ramp;
    const stops = colours.map((colour, k) => [k / (colours.length - 1), colour] as const);
    return [{ kind: 'scale', title: name, stops, low: least, high: most, isClipped: false }];
  });
  const lines = drawn.filter(({ found }) => found?.kind === 'vector').map(({ name, colour }) => ({ name, colour }));
  return lines.length > 0 ? [...scales, { kind: 'kinds', title: 'Layers', kinds: lines }] : scales;
}
