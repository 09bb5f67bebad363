// What if beside the answers: the same rocks with other inputs and other rock models, in the background.

import { computed, effect } from '@preact/signals';
import { shapeOf } from '../askLine/shape';
import { begin, knownOf, questionKey, whatIfOf } from '../askLine/whatIf';
import { hasResults, runs, shown } from '../runs/runs';
import { varies } from '../state/varies';
import { shouldBegin } from './jobStep';
import { lineAnswer } from './lineAnswer';
import { place } from './place';

/// The job of the shown run and the chosen place; null: there is none.
export const job = computed(() => place.value && whatIfOf(shapeOf(place.value)));

/// Once more, or for the first time.
export const vary = () => void (place.peek() && begin(shapeOf(place.peek()!), { models: true }));

const rest = 1200; // ms that the line and the run must stay the same
let begun: string | null = null;
let timer: ReturnType<typeof setTimeout> | undefined;

effect(() => {
  const [run, now] = [shown.value, place.value];
  const isAnswered = run !== null && now !== null && hasResults(run) && lineAnswer.value.value !== null;
  const question = isAnswered ? questionKey(run.id, shapeOf(now)) : null;
  const isDue = shouldBegin({
    isOn: varies.value,
    question,
    isComputing: runs.value.some(({ state }) => state === 'running' || state === 'waiting'),
    isKnown: knownOf.value === run?.id,
    last: job.value && question,
    begun,
  });
  clearTimeout(timer);
  if (isDue)
    timer = setTimeout(() => {
      begun = question;
      vary();
    }, rest);
});
