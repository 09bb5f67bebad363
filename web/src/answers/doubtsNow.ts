// The doubts about the answers as they are shown now, with those of the job that varies inputs and models.

import { computed } from '@preact/signals';
import { refusal } from '../askLine/whatIf';
import { isOutdated } from '../runs/outdated';
import { doubtsOf, warningText, type Doubt } from './doubts';
import { job } from './job';
import { lineAnswer } from './lineAnswer';
import { summary } from './place';

export const doubts = computed<Doubt[]>(() => {
  const state = job.value;
  const ofJob = state ? state.problems.map(({ text }) => warningText(text)) : refusal.value !== null ? [`Inputs and rock models cannot be varied: ${refusal.value}`] : [];
  return [
    ...doubtsOf({ answer: lineAnswer.value.value, whatIf: state?.answer ?? null, summary: summary.value, isOutdated: isOutdated.value }),
    ...ofJob.map((text): Doubt => ({ kind: 'job', text, advice: '' })),
  ];
});
