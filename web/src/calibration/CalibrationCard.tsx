import { useState } from 'preact/hooks';
import type { Run } from '../api/types';
import { RunStateText } from '../runList/RunStateText';
import { showCalibration, remove, resume, shownCalibration, stop } from '../runs/runs';
import { openResults, resultsTab, showTab } from '../state/panels';
import { Dialog } from '../ui/Dialog';
import { clockText, momentText } from '../units/texts';
import { counted } from '../units/numbers';

/// A calibration of the list.
export function CalibrationCard({ run }: { run: Run }) {
  const [isDeleting, askToDelete] = useState(false);
  const isUnderWay = run.state === 'running' || run.state === 'waiting';
  const isShown = shownCalibration.value?.id === run.id && resultsTab.value === 'calibration';
  return (
    <li class={isShown ? 'run shown' : 'run'} data-run={run.id}>
      <strong>{run.name}</strong>
      <RunStateText run={run} />
      {run.state === 'running' && (
        <div class="run-progress">
          <progress max={run.rocks} value={run.done} aria-label={`Sets done of ${run.name}`} />
          {run.seconds_left !== null && <span class="mono">{clockText(run.seconds_left)} left</span>}
        </div>
      )}
      <p class="faint">
        {momentText(run.begun)} · {counted(run.rocks, 'set')} · {run.study}
      </p>
      {run.problems
        .filter(({ severity }) => severity === 'error')
        .map((problem) => (
          <span key={problem.text} class="problem error">
            {problem.text}
          </span>
        ))}
      <div class="run-buttons">
        {run.has_results && (
          <button
            class="button"
            aria-pressed={isShown}
            onClick={() => {
              showCalibration(run.id);
              showTab('calibration');
              openResults();
            }}
          >
            Results
          </button>
        )}
        {isUnderWay && (
          <button class="button" onClick={() => void stop(run.id)}>
            Stop
          </button>
        )}
        {['stopped', 'interrupted', 'failed'].includes(run.state) && (
          <button class="button" onClick={() => void resume(run.id)}>
            Resume
          </button>
        )}
        {!isUnderWay && (
          <button class="button plain" onClick={() => askToDelete(true)}>
            Delete…
          </button>
        )}
      </div>
      {isDeleting && (
        <Dialog title="Delete this calibration?" close={() => askToDelete(false)}>
          <p>
            Its results in <span class="mono">{run.folder}</span> will be deleted. This cannot be undone. The study file{' '}
            <span class="mono">{run.study}</span> stays.
          </p>
          <div class="dialog-buttons">
            <button class="button" onClick={() => askToDelete(false)}>
              Keep
            </button>
            <button
              class="button danger"
              onClick={() => {
                askToDelete(false);
                void remove(run.id).then(() => document.querySelector<HTMLElement>('.calibrate h2')?.focus());
              }}
            >
              Delete
            </button>
          </div>
        </Dialog>
      )}
    </li>
  );
}
