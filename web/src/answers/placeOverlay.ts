// Shows the line, area or barrier of the answers in the views; an asked one with its card open is drawn by the card.

import { effect } from '@preact/signals';
import type { AskedAnswer } from '../api/line';
import type { Point3 } from '../api/types';
import { isAsking } from '../askLine/asked';
import { placeLabel } from '../askLine/shape';
import { mostNeededOverlays } from '../askLine/stretches';
import { shown } from '../runs/runs';
import { showOverlay, type Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { lineAnswer } from './lineAnswer';
import { place } from './place';

function drawnOf(of: AskedAnswer): Pick<Overlay, 'points' | 'kind' | 'width'> {
  if (of.kind === 'polygon') return { points: of.outline.flatMap(([x, y, z]): Point3[] => (z === null ? [] : [[x, y, z]])), kind: 'polygon', width: 5 };
  return of.foot.length > 1 ? { points: [...of.foot], kind: 'line', width: 5 } : { points: [...of.foot], kind: 'points' };
}

effect(() => {
  const [found, now, run] = [lineAnswer.value.value, place.value, shown.value];
  if (!found || !now || !run || isAsking.value) return showOverlay('line of the answers', []);
  const named = { name: placeLabel(now, run.dimension), isFitted: true };
  const most = found.kind === 'polygon' ? [] : mostNeededOverlays(found);
  showOverlay('line of the answers', [{ ...drawnOf(found), colour: markColours.asked, isBare: true, place: named }, ...most]);
});
