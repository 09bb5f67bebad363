// Describes incomplete entries.

import { pathOf } from '../settings/names';
import { thingOf } from './place';
import { fieldOf } from '../settings/declared';
import { hasTyped, unfinished } from './unfinished';
import { isBlank, rowsText, type Waiting } from '../settings/waitingRows';

/// "Section of terrain, row 20".
export function placeOf(path: string, rows: readonly Waiting[]): string {
  const parts = pathOf(path);
  const isInList = typeof parts[1] === 'number';
  const field = fieldOf(String(parts[0]), String(parts[isInList ? 2 : 1]));
  const polyline = !isInList && typeof parts[2] === 'number' ? `, polyline ${parts[2] + 1}` : '';
  const where = `${field?.title ?? parts.at(-1)} of ${thingOf(parts)}${polyline}`;
  return field?.type.kind === 'tuple' ? where : `${where}, ${rowsText(rows.filter(({ cells }) => !isBlank(cells)))}`;
}

/// All settings with incomplete entries.
export const unfinishedSettings = () => Object.entries(unfinished.value).filter(([, rows]) => hasTyped(rows));

/// A remark on a run or a saved file: ", without incomplete entries: Section of terrain, row 20"; empty if there are none.
export function leftOut(): string {
  const places = unfinishedSettings().map(([path, rows]) => placeOf(path, rows));
  if (places.length === 0) return '';
  return `, without incomplete entries: ${places.join('; ')}`;
}
