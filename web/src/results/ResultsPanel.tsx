import { shown } from '../state/runs';

export function ResultsPanel() {
  if (!shown.value) return null;
  return <section class="results" aria-label="Results" />;
}
