// Says for what the sheet of the answers waits, with the choice not to.

import { runs } from '../runs/runs';
import { ranges } from './job';
import { leaveSheet, printNow, waitsFor } from './sheetWaits';

function stateText(): string {
  const job = ranges.value?.job;
  if (job?.state === 'running') return job.seconds_left === null ? '' : `, ${Math.ceil(job.seconds_left)} s left`;
  return runs.value.some(({ state }) => state === 'running' || state === 'waiting') ? ', which begin after the run under way' : ', which begin in a moment';
}

export function SheetWaits() {
  if (waitsFor.value === null) return null;
  const job = ranges.value?.job;
  return (
    <div class="sheet-waits" role="status" aria-label="The sheet waits">
      <span>The sheet is printed with the ranges over inputs and models{stateText()}.</span>
      <progress aria-label="Ranges of the sheet" {...(job && { max: Math.max(job.planned, 1), value: job.done })} />
      <button class="button" title="The sheet says that they were still being computed" onClick={printNow}>
        Print now, without
      </button>
      <button class="button plain" onClick={leaveSheet}>
        Cancel
      </button>
    </div>
  );
}
