// What if beside the answers: the same rocks with other inputs and other rock models, in the background.

import { batch, computed, effect, signal } from '@preact/signals';
import type { WhatIfState } from '../api/whatIf';
import { shapeOf } from '../askLine/shape';
import { begin, isBeginning, knownOf, questionKey, refusalOf, whatIfOf } from '../askLine/whatIf';
import { hasResults, runs, shown } from '../runs/runs';
import { varies } from '../state/varies';
import { shouldBegin } from './jobStep';
import { lineAnswer } from './lineAnswer';
import { place } from './place';
import { rangesOf } from './ranges';

/// The job of the shown run and the chosen place; null: there is none.
export const job = computed(() => place.value && whatIfOf(shapeOf(place.value)));

/// What is asked of the shown run; null: nothing that has an answer.
const question = computed(() => {
  const [run, now] = [shown.value, place.value];
  const isAnswered = run !== null && now !== null && hasResults(run) && lineAnswer.value.value !== null;
  return isAnswered ? questionKey(run.id, shapeOf(now)) : null;
});
const begun = signal<string | null>(null);

/// Once more, or for the first time; for so many seconds, at most, or as long as usual.
export function vary(seconds?: number) {
  batch(() => {
    const now = place.peek();
    begun.value = question.peek();
    if (now) void begin(shapeOf(now), { models: true, ...(seconds !== undefined && { seconds }) });
  });
}

const longest = 600; // s, of the server
/// How much longer a job may take that had too little time for all rocks of the run [s]; null: it had enough, or all there is.
export function longerThan(of: WhatIfState | null): number | null {
  const isShort = of?.state === 'done' && of.answer !== null && of.answer.rocks < of.answer.planned;
  return isShort && of.seconds < 0.9 * longest ? Math.min(longest, Math.max(60, Math.ceil(4 * of.seconds))) : null;
}

/// How far it is; null: nothing is asked.
export const ranges = computed(() => {
  const now = place.value;
  if (!now) return null;
  const shape = shapeOf(now);
  return rangesOf({
    job: job.value,
    refusal: refusalOf(shape),
    isOn: varies.value,
    isBeginning: isBeginning(shape),
    wasBegun: question.value !== null && begun.value === question.value,
  });
});

const rest = 1200; // ms that the line and the run must stay the same
let timer: ReturnType<typeof setTimeout> | undefined;

effect(() => {
  const isDue = shouldBegin({
    isOn: varies.value,
    question: question.value,
    isComputing: runs.value.some(({ state }) => state === 'running' || state === 'waiting'),
    isKnown: knownOf.value === shown.value?.id,
    last: job.value && question.value,
    begun: begun.value,
  });
  clearTimeout(timer);
  if (isDue) timer = setTimeout(() => vary(), rest);
});
