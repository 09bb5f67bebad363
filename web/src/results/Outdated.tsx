import { isOutdated } from '../runs/outdated';
import { problems } from '../state/model';
import { compute } from '../state/runs';
import { sidePanel } from '../state/view';

/// That the results are not those of the project as it stands, and a way to have them.
export function Outdated() {
  if (!isOutdated.value) return null;
  const hasErrors = problems.value.some(({ severity }) => severity === 'error');
  return (
    <p class="outdated" role="status">
      <span>These results are of an earlier text of the project.</span>
      <button
        class="button"
        disabled={hasErrors}
        title={hasErrors ? 'The model has errors: see the list in the panel at the left' : undefined}
        onClick={() => void compute()}
      >
        Compute again
      </button>
      <button class="button plain" onClick={() => (sidePanel.value = 'runs')}>
        Runs
      </button>
    </p>
  );
}
