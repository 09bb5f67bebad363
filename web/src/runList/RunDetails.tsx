import type { Run } from '../api/types';
import type { ValueDifference } from '../toml/differences';
import { DifferenceTable } from './Differences';
import { RunFiles } from './RunFiles';

/// The details of a run: problems, changes since, files.
export function RunDetails({ run, changes }: { run: Run; changes: ValueDifference[] | null }) {
  return (
    <div class="run-details">
      {run.problems.map((problem) => (
        <span key={problem.text} class={`problem ${problem.severity}`}>
          {problem.text}
        </span>
      ))}
      {changes && changes.length > 0 && (
        <>
          <h3>Changed since</h3>
          <DifferenceTable rows={changes} here="This run" there="Project now" />
        </>
      )}
      {changes?.length === 0 && <p class="faint">The project has not changed since.</p>}
      <h3>Files</h3>
      <p class="faint">
        In <span class="mono">{run.folder}</span>
      </p>
      <RunFiles run={run} />
    </div>
  );
}
