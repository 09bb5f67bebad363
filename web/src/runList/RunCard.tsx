import { useId, useState } from 'preact/hooks';
import type { Run } from '../api/types';
import { comparedId, compareWith, hasResults, remove, resume, show, shown, shownId, stop } from '../runs/runs';
import { Dialog } from '../ui/Dialog';
import { clockText, momentText } from '../units/texts';
import { counted, numberText } from '../units/numbers';
import { RunDifferences } from './Differences';
import { RunDetails } from './RunDetails';
import { RunName } from './RunName';
import { RunReport } from './RunReport';
import { RunStateText } from './RunStateText';
import { useChanges } from './changes';

function Facts({ run }: { run: Run }) {
  const facts = [
    momentText(run.begun),
    counted(run.rocks, 'rock'),
    run.seconds > 0 && (run.seconds < 60 ? `${numberText(run.seconds, 2)} s` : clockText(run.seconds)),
    run.rate !== null && run.rate > 0 && `${Math.round(run.rate).toLocaleString('en')} rocks/s`,
  ];
  return <p class="faint">{facts.filter(Boolean).join(' · ')}</p>;
}

function Progress({ run }: { run: Run }) {
  return (
    <div class="run-progress">
      <progress max={run.rocks} value={run.done} aria-label={`Rocks done of ${run.name}`} />
      {run.seconds_left !== null && <span class="mono">{clockText(run.seconds_left)} left</span>}
    </div>
  );
}

/// The element to focus after a run is deleted: the next run, or else the tab.
function placeAfter(run: Run): HTMLElement | null {
  const card = document.querySelector(`[data-run="${run.id}"]`);
  const next = card?.nextElementSibling ?? card?.previousElementSibling;
  const tab = card?.closest('.side')?.querySelector<HTMLElement>('[role="tab"][aria-selected="true"]');
  return next?.querySelector<HTMLElement>('.run-name') ?? tab ?? null;
}

function DeleteDialog({ run, close }: { run: Run; close: () => void }) {
  return (
    <Dialog title="Delete this run?" close={close}>
      <p>
        “{run.name}” and its folder <span class="mono">{run.folder}</span> will be deleted. This cannot be undone.
      </p>
      <div class="dialog-buttons">
        <button class="button" onClick={close}>
          Keep
        </button>
        <button
          class="button danger"
          onClick={() => {
            const next = placeAfter(run);
            close();
            void remove(run.id).then(() => next?.focus());
          }}
        >
          Delete
        </button>
      </div>
    </Dialog>
  );
}

/// A run of the list. `isRecent`: among the newest, whose texts are compared with the project at once.
export function RunCard({ run, isRecent }: { run: Run; isRecent: boolean }) {
  const [isOpen, open] = useState(false);
  const [isDeleting, askToDelete] = useState(false);
  const details = useId();
  const changes = useChanges(run, isRecent || isOpen);
  const isShown = run.id === shownId.value;
  const isCompared = run.id === comparedId.value;
  const isUnderWay = run.state === 'running' || run.state === 'waiting';
  const errors = run.problems.filter(({ severity }) => severity === 'error').length;
  const warnings = run.problems.length - errors;
  return (
    <li class={`run ${isShown ? 'shown' : isCompared ? 'compared' : ''}`} data-run={run.id}>
      <RunName run={run} />
      <RunStateText run={run} />
      {run.state === 'running' && <Progress run={run} />}
      <Facts run={run} />
      {(changes?.length || run.problems.length > 0) && (
        <p class="run-marks">
          {changes && changes.length > 0 && <span class="mark">from an older version</span>}
          {errors > 0 && <span class="mark error">{counted(errors, 'error')}</span>}
          {warnings > 0 && <span class="mark warning">{counted(warnings, 'warning')}</span>}
        </p>
      )}
      <div class="run-buttons">
        <button
          class="button"
          aria-pressed={isShown}
          onClick={() => {
            show(isShown ? null : run.id);
            if (isCompared) compareWith(null);
          }}
        >
          Show
        </button>
        {hasResults(run) && !isShown && shown.value && (
          <button class="button" aria-pressed={isCompared} onClick={() => compareWith(isCompared ? null : run.id)}>
            Compare
          </button>
        )}
        {isShown && hasResults(run) && <RunReport run={run} />}
        {isUnderWay && (
          <button class="button" title="Finished rocks are kept" onClick={() => void stop(run.id)}>
            Stop
          </button>
        )}
        {['stopped', 'interrupted', 'failed'].includes(run.state) && (
          <button class="button" title="Runs the remaining rocks" onClick={() => void resume(run.id)}>
            Resume
          </button>
        )}
        <button class="button plain" aria-expanded={isOpen} aria-controls={details} onClick={() => open(!isOpen)}>
          Details
        </button>
        {!isUnderWay && (
          <button class="button plain danger" onClick={() => askToDelete(true)}>
            Delete
          </button>
        )}
      </div>
      {isCompared && shown.value && (
        <>
          <h3>Differences</h3>
          <RunDifferences run={shown.value} other={run} />
        </>
      )}
      <div id={details}>{isOpen && <RunDetails run={run} changes={changes} />}</div>
      {isDeleting && <DeleteDialog run={run} close={() => askToDelete(false)} />}
    </li>
  );
}
