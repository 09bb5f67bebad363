// The runs of the open project, newest first.

import { areKnown, compute, ownRuns } from '../runs/runs';
import { problems } from '../project/model';
import { RunCard } from './RunCard';
import './runs.css';

const recent = 20;

export function RunsPanel() {
  if (!areKnown.value) return <div class="empty">Loading the runs…</div>;
  const runs = ownRuns.value;
  if (runs.length === 0) {
    const hasErrors = problems.value.some(({ severity }) => severity === 'error');
    return (
      <div class="empty">
        <p>No run yet. A run simulates the rocks of the project and keeps the results.</p>
        {hasErrors ? (
          <p>The model has errors, listed under Model. Correct them first.</p>
        ) : (
          <button class="button first" style={{ justifySelf: 'center' }} onClick={() => void compute()}>
            Compute
          </button>
        )}
      </div>
    );
  }
  return (
    <ul class="runs" aria-label="Runs">
      {runs.map((run, k) => (
        <RunCard key={run.id} run={run} isRecent={k < recent} />
      ))}
    </ul>
  );
}
