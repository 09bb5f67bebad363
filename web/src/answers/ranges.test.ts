import { expect, test } from 'vitest';
import type { WhatIfState } from '../api/whatIf';
import { arePending, printedText, rangesOf, type Begun } from './ranges';

const job = (state: WhatIfState['state'], rocks: number | null, problems: string[] = []) =>
  ({ state, answer: rocks === null ? null : { rocks }, problems: problems.map((text) => ({ text })) }) as unknown as WhatIfState;
const begun = (of: Partial<Begun>) => rangesOf({ job: null, refusal: null, isOn: true, isBeginning: false, wasBegun: false, ...of });

test('before the job begins, or is known, its ranges are ahead, not left out', () => {
  for (const each of [begun({}), begun({ isBeginning: true, wasBegun: true }), begun({ isOn: false, isBeginning: true })]) expect([each.state, arePending(each)]).toEqual(['ahead', true]);
  expect(printedText(begun({}))).toBe('Inputs and rock models were still being computed when this sheet was printed.');
  expect(printedText(begun({ job: job('running', 40) }))).toBe('Inputs and rock models were still being computed when this sheet was printed, so far with 40 rocks in each set.');
});

test('"not varied" is said where nothing will come, with its reason', () => {
  const off = begun({ isOn: false });
  expect([off.state, arePending(off)]).toEqual(['off', false]);
  expect(printedText(off)).toBe('Inputs and rock models were not varied: this is switched off in the menu of Compute.');
  expect(printedText(begun({ refusal: 'the run has no stored trajectories.', wasBegun: true }))).toBe('Inputs and rock models could not be varied: the run has no stored trajectories.');
  expect(printedText(begun({ job: job('failed', null, ['what if failed: no memory']) }))).toBe('Inputs and rock models could not be varied: what if failed: no memory.');
  expect(printedText(begun({ job: job('stopped', 12) }))).toBe('Varying inputs and rock models was stopped before its end, with 12 rocks in each set.');
  expect(printedText(begun({ wasBegun: true }))).toBe('Inputs and rock models: unknown, the server no longer has them.');
  expect(printedText(begun({ job: job('done', 50) }))).toBe('');
});
