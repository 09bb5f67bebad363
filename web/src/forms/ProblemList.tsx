// The errors and warnings of the project. Each leads to its form.

import type { Problem } from '../api/types';
import { syntaxError } from '../project/document';
import { choose } from '../project/chosen';
import { showPanel } from '../state/panels';
import { counted } from '../units/numbers';
import { pathOf, type Path } from '../settings/names';
import { sectionOf } from '../settings/sections';
import { realProblems, sentenceOf, toneOf } from '../project/awaited';

/// The path of the form in which a problem's field is.
export function formOf(path: string): Path | null {
  if (path === '') return null;
  const [table = 'analysis', index] = pathOf(path);
  const section = sectionOf([table]);
  if (section?.lists.some(({ key }) => key === table))
    return typeof index === 'number' ? [table, index] : null;
  return [section?.name ?? 'analysis'];
}

/// Opens the form of a problem and focuses its field.
function show(problem: Problem) {
  const form = formOf(problem.path);
  if (!form) {
    showPanel('text');
    return;
  }
  choose(form);
  requestAnimationFrame(() => requestAnimationFrame(() => focusField(problem.path)));
}

export function focusField(path: string) {
  for (let parts = path.split('.'); parts.length > 0; parts = parts.slice(0, -1)) {
    const field = document.querySelector<HTMLElement>(`.field[data-path="${CSS.escape(parts.join('.'))}"]`);
    if (!field) continue;
    for (let at: HTMLElement | null = field; at; at = at.parentElement)
      if (at instanceof HTMLDetailsElement) at.open = true;
    field.scrollIntoView({ block: 'nearest' });
    (
      field.querySelector<HTMLElement>('[aria-invalid="true"]') ??
      field.querySelector<HTMLElement>('input, select, textarea')
    )?.focus();
    return;
  }
}

/// Folded next to an open form, which shows its own problems.
export function ProblemList({ folded }: { folded: boolean }) {
  const list = realProblems.value;
  if (list.length === 0 && !syntaxError.value) return null;
  const errors = list.filter(({ severity }) => severity === 'error').length;
  const warnings = list.length - errors;
  const counts = [errors > 0 && counted(errors, 'error'), warnings > 0 && counted(warnings, 'warning')];
  return (
    <details class="problems" open={!folded && (errors > 0 || list.length <= 2)}>
      <summary>{counts.filter(Boolean).join(', ')}</summary>
      {list.slice(0, 50).map((problem) => (
        <button
          key={problem.text}
          class={`problem ${toneOf(problem)}`}
          title={problem.text}
          onClick={() => show(problem)}
        >
          {problem.where && <strong>{problem.where}: </strong>}
          {sentenceOf(problem)}
        </button>
      ))}
    </details>
  );
}
