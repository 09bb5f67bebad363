// The project text of a run, compared with the current text.

import { results } from '../api/results';
import type { Run } from '../api/types';
import { useRemote } from '../ui/remote';
import { file, text, values } from '../project/document';
import { differencesOf, type ValueDifference } from '../toml/differences';
import { valuesOf } from '../toml/values';

const texts = new Map<string, Promise<string>>(); // a run's text never changes

export function textOf(id: string): Promise<string> {
  const known = texts.get(id);
  if (known) return known;
  const asked = results.fileText(id, 'project.toml');
  texts.set(id, asked);
  asked.catch(() => texts.delete(id));
  return asked;
}

/// The values that differ between a run's text and the current project; null while unknown.
export function useChanges(run: Run, isWanted: boolean): ValueDifference[] | null {
  const answer = useRemote(run.id, isWanted && run.file === file.value ? run.id : null, () => textOf(run.id));
  if (answer.value === null) return null;
  if (answer.value === text.value) return [];
  try {
    return differencesOf(valuesOf(answer.value), values.value);
  } catch {
    return null;
  }
}
