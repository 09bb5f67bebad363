// The same rocks on the slope before and after a tool: two runs of the server, and what they say about one stretch.

import { effect } from '@preact/signals';
import { api } from '../api/client';
import { askDitch, type DitchAnswer } from '../api/ditch';
import type { Run } from '../api/types';
import { file, text } from '../project/document';
import { model } from '../project/model';
import { ofProject } from '../project/ofProject';
import { runs, takeAnswer } from '../runs/runs';
import { edited } from '../toml/edit';
import { editsNow, kind, preview } from './state';
import { owned } from '../state/owned';

/// Rocks of each of the two runs, unless the project has fewer.
export const mostRocks = 1000;

export interface Comparison {
  title: string;
  rocks: number;
  stretch: [number, number];
  before: DitchAnswer;
  after: DitchAnswer;
}
/// The last comparison, also after its tool was applied.
export const comparison = ofProject<Comparison | null>(null);
export const comparing = ofProject<'running' | { failed: string } | null>(null);
/// Where rocks must stay before; null: the far edge.
export const [station, setStation] = owned(ofProject<number | null>(null));

const isAtWork = ({ state }: Run) => state === 'waiting' || state === 'running';

/// Waits for the end of a run; throws if it failed or was removed.
function ended(id: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const stop = effect(() => {
      const run = runs.value.find((each) => each.id === id);
      if (run && isAtWork(run)) return;
      queueMicrotask(() => stop());
      if (run?.state === 'done') resolve();
      else reject(new Error(run ? `The run "${run.name}" did not finish${run.problems[0] ? `: ${run.problems[0].text}` : '.'}` : 'The run was removed.'));
    });
  });
}

async function answerOf(project: string, body: string, name: string, rocks: number, [toe, far]: [number, number]): Promise<DitchAnswer> {
  const run = await api.compute(project, body, { name, rocks });
  takeAnswer(run);
  await ended(run.id);
  return askDitch(run.id, toe, far);
}

/// Runs both; the seed is that of the project, so that rocks start the same way.
export async function compare() {
  const [tool, made, edits, project] = [kind.peek(), preview.peek(), editsNow(), file.peek()];
  if (!tool || !made || !('value' in made) || !edits || project === null || comparing.peek() === 'running') return;
  const [toe, far] = made.value.keeps;
  const before = text.peek();
  const after = edited(before, edits);
  const rocks = Math.min(model.peek()?.rocks ?? mostRocks, mostRocks);
  const stretch: [number, number] = [toe, station.peek() ?? far];
  if ((stretch[1] - toe) * (far - toe) <= 0) {
    comparing.value = { failed: `Rocks must stay before a place downhill of x = ${toe.toFixed(2)} m.` };
    return;
  }
  comparing.value = 'running';
  try {
    const answers = [
      await answerOf(project, before, `Before the ${tool}`, rocks, stretch),
      await answerOf(project, after, `With the ${tool}`, rocks, stretch),
    ] as const;
    if (file.peek() !== project) return;
    comparison.value = { title: tool, rocks, stretch, before: answers[0], after: answers[1] };
    comparing.value = null;
  } catch (error) {
    if (file.peek() === project) comparing.value = { failed: error instanceof Error ? error.message : String(error) };
  }
}
