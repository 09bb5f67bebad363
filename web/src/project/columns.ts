// Column names of settings with rows of numbers.

import type { Path } from '../settings/names';
import { is2d } from './place';

/// The columns of a setting with one or more rows.
export function columnsAt(path: Path): string[] {
  const [table, key] = [path[0], path.at(-1)];
  if (table === 'terrain') {
    if (key === 'section' || key === 'section_std_dev_m') return ['x', 'z'];
    if (key === 'triangles') return ['first', 'second', 'third'];
    return ['x', 'y', 'z'];
  }
  if (key === 'polygon' || table === 'barrier' || table === 'collector') return ['x', 'y'];
  return is2d.value ? ['x', 'z'] : ['x', 'y', 'z'];
}
