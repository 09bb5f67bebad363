// The doubts about the answers as they are shown now, with those of the job that varies inputs and models.

import { computed } from '@preact/signals';
import { values } from '../project/document';
import { isOutdated } from '../runs/outdated';
import { isTable } from '../settings/tables';
import { doubtsOf, warningText, type Doubt } from './doubts';
import { ranges } from './job';
import { lineAnswer } from './lineAnswer';
import { summary } from './place';

const hasRemark = computed(() => {
  const block = values.value.report;
  return isTable(block) && typeof block.text === 'string';
});

export const doubts = computed<Doubt[]>(() => {
  const now = ranges.value;
  const ofJob = now?.state === 'refused' ? [`Inputs and rock models cannot be varied: ${now.why}`] : (now?.job?.problems ?? []).map(({ text }) => warningText(text));
  return [
    ...doubtsOf({ answer: lineAnswer.value.value, whatIf: now?.job?.answer ?? null, summary: summary.value, isOutdated: isOutdated.value, hasRemark: hasRemark.value }),
    ...ofJob.map((text): Doubt => ({ kind: 'job', text, advice: '' })),
  ];
});
