import { isOutdated } from '../runs/outdated';
import { problems } from '../project/model';
import { compute } from '../runs/runs';
import { showPanel } from '../state/panels';

/// A notice that the results are not those of the current project, with a button to compute again.
export function Outdated() {
  if (!isOutdated.value) return null;
  const hasErrors = problems.value.some(({ severity }) => severity === 'error');
  return (
    <p class="outdated" role="status">
      <span>These results are from an earlier version of the project.</span>
      <button
        class="button"
        disabled={hasErrors}
        title={hasErrors ? 'The model has errors, listed in the panel on the left' : undefined}
        onClick={() => void compute()}
      >
        Compute again
      </button>
      <button class="button plain" onClick={() => showPanel('runs')}>
        Runs
      </button>
    </p>
  );
}
