// The project text of a run.

import { results } from '../api/results';

const texts = new Map<string, Promise<string>>(); // a run's text never changes

export function textOf(id: string): Promise<string> {
  const known = texts.get(id);
  if (known) return known;
  const asked = results.fileText(id, 'project.toml');
  texts.set(id, asked);
  asked.catch(() => texts.delete(id));
  return asked;
}
