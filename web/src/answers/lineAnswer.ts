// What the shown run says of the chosen place. While the card of the asked line is open, its answer is used, which also
// follows a drag.

import { computed } from '@preact/signals';
import { asking, type AskedAnswer } from '../api/line';
import { answer, asked, isAsking, refusal } from '../askLine/asked';
import { shapeOf } from '../askLine/shape';
import { shown } from '../runs/runs';
import { loadedFor, type Loaded } from '../state/loaded';
import { place } from './place';

/// Whether the card asks for the same place.
const isAskedByCard = computed(() => isAsking.value && place.value !== null && place.value === asked.value);

const own = loadedFor<AskedAnswer>(() => {
  const [run, now] = [shown.value, place.value];
  if (!run || !now || isAskedByCard.value) return null;
  const shape = shapeOf(now);
  return { key: `${run.id} ${run.done} ${JSON.stringify(shape)}`, load: (signal) => asking.ask(run.id, { ...shape, sources: false }, signal) };
});

export const lineAnswer = computed<Loaded<AskedAnswer>>(() => (isAskedByCard.value ? { value: answer.value, error: refusal.value } : own.value));
