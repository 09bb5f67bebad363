// What has changed in the project since a run.

import type { Run } from '../api/types';
import { file, text, values } from '../project/document';
import { textOf } from '../runs/runText';
import { differencesOf, type ValueDifference } from '../toml/differences';
import { valuesOf } from '../toml/values';
import { useRemote } from '../ui/remote';

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
