// Whether what is shown was computed from the project as it stands.

import { computed, effect, signal } from '@preact/signals';
import { sayFailure } from '../state/messages';
import { file, text, values } from '../state/document';
import { hasResults, shown } from '../state/runs';
import { differencesOf } from '../toml/differences';
import { valuesOf } from '../toml/edit';
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
    }, sayFailure);
});

const then = computed(() => {
  try {
    return known.value && valuesOf(known.value.text);
  } catch {
    return null;
  }
});

/// The values of the run that is shown are not those of the project; false, too, while that is not known.
export const isOutdated = computed(
  () => then.value !== null && known.value?.text !== text.value && differencesOf(then.value, values.value).length > 0,
);
