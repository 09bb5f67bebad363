// What is typed but not complete: where it stands, so that it is not forgotten.

import { chosen } from '../state/view';
import { placeOf, unfinishedSettings } from './leftOut';
import { formOf, focusField } from './ProblemList';
import { wait } from './unfinished';

export function UnfinishedList() {
  const all = unfinishedSettings();
  if (all.length === 0) return null;
  const show = (path: string) => {
    chosen.value = formOf(path);
    requestAnimationFrame(() => requestAnimationFrame(() => focusField(path)));
  };
  return (
    <section class="unfinished" aria-label="Not complete">
      {all.map(([path, rows]) => (
        <div key={path} class="problem warning">
          Not complete, and not taken yet:
          <button class="link" onClick={() => show(path)}>
            {placeOf(path, rows)}
          </button>
          <button
            class="mini"
            title="Discard"
            aria-label={`Discard ${placeOf(path, rows)}`}
            onClick={() => wait(path, [])}
          >
            ✕
          </button>
        </div>
      ))}
    </section>
  );
}
