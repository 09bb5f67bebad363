// The doubts about the answers, the most serious ones in sight.

import { read } from '../help/Document';
import { resultsOpen } from '../state/panels';
import type { Doubt } from './doubts';

/// How many are in sight.
const most = 2;
const whichModel = { document: 'which-model.md', heading: 'Which model?' };

function OneDoubt({ of: { kind, text, advice } }: { of: Doubt }) {
  return (
    <li>
      {text} {advice}
      {kind === 'models' && (
        <button class="button plain" onClick={() => read(whichModel)}>
          Which model?
        </button>
      )}
    </li>
  );
}

const List = ({ of }: { of: readonly Doubt[] }) => (
  <ul>
    {of.map((doubt) => (
      <OneDoubt key={doubt.text} of={doubt} />
    ))}
  </ul>
);

/// Beside open tables in brief.
export function Banner({ of: all }: { of: readonly Doubt[] }) {
  if (all.length === 0) return null;
  if (resultsOpen.value)
    return (
      <div class="doubts" role="status" aria-label="Doubts">
        <details class="in-brief">
          <summary>
            {all.length > 1 && `${all.length} doubts. `}
            {all[0]!.text}
          </summary>
          <List of={all} />
        </details>
      </div>
    );
  const rest = all.slice(most);
  return (
    <div class="doubts" role="status" aria-label="Doubts">
      <List of={all.slice(0, most)} />
      {rest.length > 0 && (
        <details>
          <summary>{`${rest.length} more`}</summary>
          <List of={rest} />
        </details>
      )}
    </div>
  );
}
