// Incomplete entries, with links to their fields.

import { choose } from '../project/chosen';
import { placeOf, unfinishedSettings } from '../project/leftOut';
import { formOf, focusField } from './ProblemList';
import { keepWaiting } from '../project/unfinished';

export function UnfinishedList() {
  const all = unfinishedSettings();
  if (all.length === 0) return null;
  const show = (path: string) => {
    choose(formOf(path));
    requestAnimationFrame(() => requestAnimationFrame(() => focusField(path)));
  };
  return (
    <section class="unfinished" aria-label="Incomplete entries">
      {all.map(([path, rows]) => (
        <div key={path} class="problem warning">
          Incomplete, not part of the project yet:
          <button class="link" onClick={() => show(path)}>
            {placeOf(path, rows)}
          </button>
          <button
            class="mini"
            title="Discard"
            aria-label={`Discard ${placeOf(path, rows)}`}
            onClick={() => keepWaiting(path, [])}
          >
            ✕
          </button>
        </div>
      ))}
    </section>
  );
}
