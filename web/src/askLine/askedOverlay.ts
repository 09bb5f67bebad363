// Shows what is asked in the views: its line, its corners, and its worst stretch.

import { effect, signal } from '@preact/signals';
import type { Point3 } from '../api/types';
import { showOverlay, type Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { answer, askedNow, draggedPoints, isAsking } from './asked';
import { shown } from '../runs/runs';
import { cornersOf, groundOf } from './askTools';
import { partOf } from './foot';
import { placeLabel } from './shape';
import { owned } from '../state/owned';

/// The part of the line under the pointer in the figure, from and to [m].
export const [pointedPart, pointAt] = owned(signal<[number, number] | null>(null));

effect(() => {
  const now = askedNow.value;
  if (!isAsking.value || !now) return showOverlay('asked line', []);
  const corners = cornersOf(now);
  // While it is dragged the answer is that of an earlier place.
  // That of an area has only the corners.
  const ground = draggedPoints.value === null && now.kind !== 'polygon' ? groundOf() : [];
  const line = ground.length > 1 ? ground : corners;
  const kind: Overlay['kind'] = now.kind === 'polygon' ? 'polygon' : 'line';
  const colour = markColours.asked;
  const place = { name: placeLabel(now, shown.value?.dimension ?? 3), isFitted: draggedPoints.value === null };
  showOverlay('asked line', [
    ...(line.length > 1 ? [{ points: line, kind, colour, isBare: true, width: 5, place }] : []),
    { points: corners, kind: 'points', colour, ...(line.length === 1 && { place }) },
  ]);
});

effect(() => {
  const found = answer.value;
  const pointed = pointedPart.value;
  const shown = isAsking.value && draggedPoints.value === null && found !== null && found.kind !== 'polygon' ? found : null;
  const part = (from: number, to: number): Point3[] => (shown ? partOf(shown.foot, from, to) : []);
  const { worst } = shown ?? {};
  const lists: Overlay[] = [];
  if (worst) lists.push({ points: part(worst.from_m, worst.to_m), kind: 'line', colour: markColours.worst, isBare: true, width: 6 });
  if (pointed) lists.push({ points: part(...pointed), kind: 'line', colour: markColours.asked, isBare: true, width: 6 });
  showOverlay('asked stretch', lists.filter(({ points }) => points.length > 1));
});
