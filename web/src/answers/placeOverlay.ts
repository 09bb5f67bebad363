// Shows the line or area of the answers in the views while its card is closed; barriers and collectors are drawn anyway.

import { effect } from '@preact/signals';
import type { Point3 } from '../api/types';
import { isAsking } from '../askLine/asked';
import { showOverlay, type Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { lineAnswer } from './lineAnswer';

const colour = markColours.asked;

effect(() => {
  const found = isAsking.value ? null : lineAnswer.value.value;
  const points = (list: readonly Point3[]): Overlay => ({ points: [...list], kind: 'points', colour });
  const lists: Overlay[] = [];
  if (found?.kind === 'polygon') {
    const corners = found.outline.flatMap(([x, y, z]): Point3[] => (z === null ? [] : [[x, y, z]]));
    lists.push({ points: corners, kind: 'polygon', colour, isBare: true });
  } else if (found?.kind === 'line') {
    lists.push(found.foot.length > 1 ? { points: found.foot, kind: 'line', colour, isBare: true, width: 4 } : points(found.foot));
  }
  showOverlay('line of the answers', lists);
});
