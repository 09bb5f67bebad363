// Sections of the documentation on settings.

import type { Topic } from '../settings/schema';
import { fieldOf, tableOf, tables } from '../settings/declared';
import type { Path } from '../settings/names';

export const topics: readonly Topic[] = tables.flatMap(({ topic, fields }) =>
  [topic, ...fields.map((field) => field.topic)].filter((one) => one !== undefined),
);

/// The topic of the setting at a path of the project.
export function topicOf(path: Path): Topic | undefined {
  const [table, key] = [String(path[0]), String(path.at(-1))];
  return path.length < 2 ? undefined : (fieldOf(table, key)?.topic ?? tableOf(table)?.topic);
}
