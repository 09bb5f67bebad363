import { fileAddress, results } from '../api/results';
import type { Run } from '../api/types';
import { useRemote } from '../ui/remote';
import { Waiting } from '../ui/Waiting';
import { bytesText } from '../units/texts';

/// Links to the files of a run.
export function RunFiles({ run }: { run: Run }) {
  const answer = useRemote(run.id, run.state, (signal) => results.files(run.id, signal));
  if (!answer.value) return <Waiting of={answer} />;
  const isReport = (name: string) => /(^|\/)report\.html$/.test(name);
  const files = [...answer.value].sort((a, b) => Number(isReport(b.name)) - Number(isReport(a.name)));
  if (files.length === 0) return <p class="faint">No files yet.</p>;
  return (
    <ul class="run-files">
      {files.map(({ name, bytes }) => (
        <li key={name}>
          <a href={fileAddress(run.id, name)} download={name.split('/').at(-1)}>
            {name}
          </a>
          <span class="faint">{bytesText(bytes)}</span>
        </li>
      ))}
    </ul>
  );
}
