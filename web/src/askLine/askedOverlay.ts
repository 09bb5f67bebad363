// Shows what is asked in the views: its line, its corners, and its worst stretch.

import { effect, signal } from '@preact/signals';
import { showOverlay, type Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { answer, askedNow, draggedPoints, isAsking } from './asked';
import { shown } from '../runs/runs';
import { cornersOf, groundOf } from './askTools';
import { partOf } from './foot';
import { placeLabel } from './shape';
import { mostNeededOverlays } from './stretches';
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
  if (!shown) return showOverlay('asked stretch', []);
  const part = pointed ? partOf(shown.foot, ...pointed) : [];
  const underPointer: Overlay[] = part.length > 1 ? [{ points: part, kind: 'line', colour: markColours.asked, isBare: true, width: 6 }] : [];
  showOverlay('asked stretch', [...mostNeededOverlays(shown), ...underPointer]);
});
