import { ownRuns, shownId } from '../state/runs';

export function RunsPanel() {
  if (ownRuns.value.length === 0) return <div class="empty">No runs yet. Compute throws the rocks.</div>;
  return (
    <ul>
      {ownRuns.value.map((run) => (
        <li key={run.id}>
          <button class="button" aria-pressed={run.id === shownId.value} onClick={() => (shownId.value = run.id)}>
            {run.name}: {run.state}, {run.done} rocks
          </button>
        </li>
      ))}
    </ul>
  );
}
