// Whether the shown results were computed from the current project.

import { computed, effect, signal } from '@preact/signals';
import { reportFailure } from '../state/messages';
import { file, text, values } from '../project/document';
import { hasResults, shown } from './runs';
import { differencesOf } from '../toml/differences';
import { valuesOf } from '../toml/values';
import { textOf } from './runText';

const own = computed(() => {
  const run = shown.value;
  return run && hasResults(run) && run.file === file.value ? run.id : null;
});
const known = signal<{ id: string; text: string } | null>(null);

effect(() => {
  const id = own.value;
  known.value = null;
  if (id !== null)
    textOf(id).then((answer) => {
      if (own.peek() === id) known.value = { id, text: answer };
    }, reportFailure);
});

const then = computed(() => {
  try {
    return known.value && valuesOf(known.value.text);
  } catch {
    return null;
  }
});

/// What only a printed page shows.
const isOnPaper = (key: string) => key === 'report' || key.startsWith('report.');

/// Whether the values of the shown run differ from those of the project, but for the title block; false while unknown.
export const isOutdated = computed(
  () => then.value !== null && known.value?.text !== text.value && differencesOf(then.value, values.value).some(({ key }) => !isOnPaper(key)),
);
