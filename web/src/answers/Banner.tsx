// The doubts about the answers, the most serious ones in sight.

import type { Problem } from '../api/types';
import { read } from '../help/Document';
import { resultsOpen } from '../state/panels';
import type { Doubt } from './doubts';

/// How many are in sight: fewer beside open tables.
const inSight = () => (resultsOpen.value ? 1 : 2);
const whichModel = { document: 'which-model.md', heading: 'Which model?' };

function OneDoubt({ of: { kind, text, todo } }: { of: Doubt }) {
  return (
    <li>
      {text} {todo}
      {kind === 'models' && (
        <button class="button plain" onClick={() => read(whichModel)}>
          Which model?
        </button>
      )}
    </li>
  );
}

export function Banner({ of, problems }: { of: readonly Doubt[]; problems: readonly Problem[] }) {
  const all: Doubt[] = [...of, ...problems.map(({ text }): Doubt => ({ kind: 'place', text, todo: '' }))];
  if (all.length === 0) return null;
  const most = inSight();
  const rest = all.slice(most);
  return (
    <div class="doubts" role="status" aria-label="Doubts">
      <ul>
        {all.slice(0, most).map((doubt) => (
          <OneDoubt key={doubt.text} of={doubt} />
        ))}
      </ul>
      {rest.length > 0 && (
        <details>
          <summary>{`${rest.length} more`}</summary>
          <ul>
            {rest.map((doubt) => (
              <OneDoubt key={doubt.text} of={doubt} />
            ))}
          </ul>
        </details>
      )}
    </div>
  );
}
