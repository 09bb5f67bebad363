import { fileAddress, results } from '../api/results';
import type { Run } from '../api/types';
import { useRemote } from '../ui/remote';

/// A link to the report of a run, if it has one.
export function RunReport({ run }: { run: Run }) {
  const report = useRemote(run.id, run.state, (signal) => results.files(run.id, signal)).value?.find(({ name }) => name === 'report.html');
  if (!report) return null;
  return (
    <a class="button" href={fileAddress(run.id, report.name)} download={`${run.name} report.html`} title="Saves the report: open it in the browser, which prints it as sheets">
      Report
    </a>
  );
}
