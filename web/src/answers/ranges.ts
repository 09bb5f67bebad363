// How far the job is that varies inputs and rock models: why a range is there, will be there, or is missing.

import type { WhatIfState } from '../api/whatIf';
import { counted } from '../units/numbers';

export type RangesState =
  | 'off' // switched off, and not begun by hand
  | 'ahead' // begins by itself
  | WhatIfState['state']
  | 'refused' // by the server
  | 'lost'; // the server no longer knows it

export interface Ranges {
  state: RangesState;
  /// Of what failed or was refused.
  why: string;
  job: WhatIfState | null;
}

export interface Begun {
  job: WhatIfState | null;
  refusal: string | null;
  isOn: boolean;
  /// Whether it is being sent to the server.
  isBeginning: boolean;
  /// Whether the page has begun it.
  wasBegun: boolean;
}

export function rangesOf({ job, refusal, isOn, isBeginning, wasBegun }: Begun): Ranges {
  const of = (state: RangesState, why = ''): Ranges => ({ state, why, job });
  if (isBeginning) return of('ahead');
  if (job) return of(job.state, job.problems.map(({ text }) => text).join('; '));
  if (refusal !== null) return of('refused', refusal);
  return of(wasBegun ? 'lost' : isOn ? 'ahead' : 'off');
}

/// Whether more is to come.
export const arePending = ({ state }: Ranges) => state === 'ahead' || state === 'running';

/// What a row of a card says that has no range.
export const missingText: Readonly<Record<RangesState, string>> = {
  off: 'not varied',
  ahead: 'follows',
  running: 'computing…',
  done: 'unknown',
  stopped: 'stopped',
  failed: 'failed',
  refused: 'not possible',
  lost: 'unknown',
};
export const missingOnPaper: typeof missingText = { ...missingText, ahead: 'still being computed', running: 'still being computed' };

/// What is to be said of them on paper; empty: they are complete.
export function printedText({ state, why, job }: Ranges): string {
  const has = job?.answer ? ` with ${counted(job.answer.rocks, 'rock')} in each set` : '';
  switch (state) {
    case 'off':
      return 'Inputs and rock models were not varied: this is switched off in the menu of Compute.';
    case 'ahead':
    case 'running':
      return `Inputs and rock models were still being computed when this sheet was printed${has && `, so far${has}`}.`;
    case 'stopped':
      return `Varying inputs and rock models was stopped before its end${has && `,${has}`}.`;
    case 'failed':
    case 'refused':
      return `Inputs and rock models could not be varied: ${why.replace(/\.$/, '')}.`;
    case 'lost':
      return 'Inputs and rock models: unknown, the server no longer has them.';
    case 'done':
      return '';
  }
}
