// A changed slope as edits of the project's text: rows outside of the stretch keep their text and comments.

import type { Edit, Path } from '../settings/names';
import { valueIn } from '../settings/tables';
import { isSame } from '../toml/differences';
import type { TomlTable, TomlValue } from '../toml/format';
import { asListed, type Slope } from './slope';

/// The edits from one list to another that replace what lies between their equal ends.
export function listEdits(path: Path, before: readonly TomlValue[], after: readonly TomlValue[]): Edit[] {
  const most = Math.min(before.length, after.length);
  let head = 0;
  while (head < most && isSame(before[head], after[head])) ++head;
  let tail = 0;
  while (tail < most - head && isSame(before.at(-1 - tail), after.at(-1 - tail))) ++tail;
  const gone = before.length - tail - head;
  const fresh = after.slice(head, after.length - tail);
  if (gone + fresh.length > 60) return [{ set: path, value: [...after] }];
  const kept = Math.min(gone, fresh.length);
  return [
    ...fresh.slice(0, kept).map((value, k): Edit => ({ set: [...path, head + k], value })),
    ...Array.from({ length: gone - kept }, (_, k): Edit => ({ remove: [...path, head + gone - 1 - k] })),
    ...fresh.slice(kept).map((value, k): Edit => ({ insert: [...path, head + kept + k], value })),
  ];
}

export function slopeEdits(values: TomlTable, next: Slope, isListedLeftwards: boolean): Edit[] {
  const { vertices, materials, deviations } = asListed(next, isListedLeftwards);
  const edits = (path: Path, after: readonly TomlValue[] | null) => {
    const before = valueIn(values, path);
    return after && Array.isArray(before) ? listEdits(path, before, after) : [];
  };
  return [
    ...edits(['terrain', 'section'], vertices),
    ...edits(['ground', 'segments'], materials),
    ...edits(['terrain', 'section_std_dev_m'], deviations),
  ];
}
