import type { Run, RunState } from '../api/types';
import { counted } from '../units/numbers';

const looks: Record<RunState, { sign: string; words: string }> = {
  waiting: { sign: '…', words: 'Waiting' },
  running: { sign: '▶', words: 'Running' },
  done: { sign: '✓', words: 'Done' },
  stopped: { sign: '■', words: 'Stopped' },
  interrupted: { sign: '!', words: 'Interrupted' },
  failed: { sign: '✕', words: 'Failed' },
};

/// "Stopped, 20 of 50 rocks".
export function stateText(run: Run): string {
  const isPart = run.state !== 'done' && run.state !== 'waiting' && run.done > 0;
  const of = `, ${run.done.toLocaleString('en')} of ${counted(run.rocks, run.kind === 'calibration' ? 'set' : 'rock')}`;
  return looks[run.state].words + (isPart ? of : '');
}

/// The state of a run as a sign and in words.
export function RunStateText({ run }: { run: Run }) {
  return (
    <span class={`run-state ${run.state}`}>
      <span class="sign" aria-hidden="true">
        {looks[run.state].sign}
      </span>
      {stateText(run)}
    </span>
  );
}
