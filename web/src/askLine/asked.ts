// The asked line or area, the kit, and the answer of the run. What is asked is not part of the project: the browser keeps it
// for each project. Every change of it is a step of Undo.

import { batch, computed, effect, signal, type ReadonlySignal } from '@preact/signals';
import { asking, type AskedAnswer, type Question } from '../api/line';
import type { Point2, Run } from '../api/types';
import { recordBeside, opening } from '../project/document';
import { filter, filterBy, setCrossingRocks } from '../runs/filter';
import { keptOfProject, ofProject } from '../project/ofProject';
import { hasResults, shown } from '../runs/runs';
import { askedOf, missingPoints, shapeOf, textOf, type Asked } from './shape';
import { owned } from '../state/owned';

const isOpen = keptOfProject<boolean>('asking a line', false);
/// Whether a line is asked: its card is open.
export const isAsking: ReadonlySignal<boolean> = isOpen;
export const openCard = (opens = true) => void (isOpen.value = opens);

const kept = keptOfProject<string>('asked line', '');
/// What is asked, as text (shape.ts); empty: nothing.
export const askedText: ReadonlySignal<string> = kept;
/// Opens the card with what an address asks; without a question it keeps its own, and null closes it.
export function openAsked(text: string | null) {
  openCard(text !== null);
  if (text) kept.value = text;
}

export const asked = computed<Asked | null>(() => (kept.value === '' ? null : askedOf(kept.value)));
/// The points while they are dragged.
export const [draggedPoints, setDraggedPoints] = owned(ofProject<Point2[] | null>(null));
/// The kit of the slider.
export const [kitHeight, setKitHeight] = owned(keptOfProject<number>('kit height', 5));
export const [kitEnergy, setKitEnergy] = owned(keptOfProject<number>('kit energy', 3000));

export type SourceColour = 'crossing' | 'clearing' | 'none';
/// What the release places are coloured by: the share of their rocks that crosses, or that the kit would not stop.
export const [sourceColour, colourSources] = owned(keptOfProject<SourceColour>('release places', 'crossing'));

/// Asks something else as one step of Undo; null: nothing. `opens`: its card, too.
export function ask(next: Asked | null, what: string, opens = true) {
  const [before, after] = [kept.peek(), textOf(next)];
  if (before === after) return;
  const put = (text: string) =>
    batch(() => {
      kept.value = text;
      if (opens) isOpen.value = true;
    });
  put(after);
  recordBeside(what, () => put(before), () => put(after));
}

/// What is asked now.
export const askedNow = computed<Asked | null>(() => {
  const [now, points] = [asked.value, draggedPoints.value];
  if (!points) return now;
  return { kind: now?.kind === 'polygon' ? 'polygon' : 'line', points };
});

/// The last answer, also while the next one is loading; null for another run or nothing asked.
export const answer = signal<AskedAnswer | null>(null);
/// The error if it could not be answered.
export const refusal = signal<string | null>(null);
/// Whether an answer is on its way.
export const isWaiting = signal(false);

function forget() {
  batch(() => {
    answer.value = null;
    refusal.value = null;
    isWaiting.value = false;
  });
}

function take(found: AskedAnswer) {
  batch(() => {
    answer.value = found;
    refusal.value = null;
    setCrossingRocks(new Set(found.crossing_rocks));
    if (filter.peek().crossing !== null) filterBy({ crossing: found.selection });
  });
}

const dragId = Math.random().toString(36).slice(2, 10);
let number = 0;
/// One request at a time: while it is answered, only the newest of the next ones waits.
let current: { controller: AbortController; key: string } | null = null;
let next: { run: Run; question: Question } | null = null;

async function send(run: Run, question: Question) {
  const own = { controller: new AbortController(), key: `${run.id} ${run.done}` };
  current = own;
  isWaiting.value = true;
  try {
    const found = await asking.ask(run.id, { ...question, drag: { id: dragId, number: ++number } }, own.controller.signal);
    if (current === own) take(found);
  } catch (error) {
    if (current === own && !own.controller.signal.aborted)
      batch(() => {
        answer.value = null;
        refusal.value = error instanceof Error ? error.message : String(error);
      });
  } finally {
    if (current === own) {
      current = null;
      isWaiting.value = false;
      const waiting = next;
      next = null;
      if (waiting) void send(waiting.run, waiting.question);
    }
  }
}

function stop() {
  next = null;
  current?.controller.abort();
  current = null;
}

let timer: ReturnType<typeof setTimeout> | undefined;
let askedBefore = '';
let runBefore = '';
effect(() => {
  const [run, now, isOpen] = [shown.value, askedNow.value, isAsking.value];
  const kit = sourceColour.value === 'clearing' ? { height_m: kitHeight.value, energy_kJ: kitEnergy.value } : {};
  clearTimeout(timer);
  if (!isOpen || !run || !hasResults(run) || !now || missingPoints(now, run.dimension) > 0) {
    stop();
    askedBefore = runBefore = '';
    return forget();
  }
  const key = `${run.id} ${run.done}`;
  if (key !== runBefore) {
    stop();
    forget();
  }
  runBefore = key;
  const question: Question = { ...shapeOf(now), ...(now.kind !== 'polygon' && kit) };
  const shape = JSON.stringify(shapeOf(now)) + key;
  // Only the kit changed: the table has what is shown at once; the sources follow when the slider rests.
  const delay = shape === askedBefore ? 250 : 0;
  askedBefore = shape;
  timer = setTimeout(() => {
    if (current) next = { run, question };
    else void send(run, question);
  }, delay);
});

// Conditions on release places and selections belong to one run.
let filteredRun: string | null = null;
effect(() => {
  void opening.value;
  const id = shown.value?.id ?? null;
  const { releases, crossing } = filter.peek();
  if (filteredRun !== null && id !== filteredRun && (releases || crossing))
    filterBy({ releases: null, crossing: null });
  filteredRun = id;
});
// Without a question there is no selection.
effect(() => {
  if (asked.value === null && filter.peek().crossing !== null) filterBy({ crossing: null });
});
