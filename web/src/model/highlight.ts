// What is chosen in the forms is marked in the view.

import { effect, untracked } from '@preact/signals';
import { showOverlay, type Overlay } from '../scene/tool';
import { model } from '../state/model';
import { chosen } from '../state/view';

export function followChosen(): () => void {
  return effect(() => {
    const path = chosen.value?.join('.');
    const seeder = model.value?.seeders.find((one) => one.path === path);
    const barrier = model.value?.barriers.find((one) => one.path === path);
    const marks: Overlay[] = [];
    if (seeder) {
      for (const points of seeder.lines) marks.push({ points, kind: seeder.type === 'polygon' ? 'polygon' : 'line' });
      if (seeder.lines.length === 0) marks.push({ points: seeder.points.slice(0, 500), kind: 'points' });
    }
    if (barrier) marks.push({ points: barrier.top, kind: 'line' }, { points: barrier.foot, kind: 'line' });
    untracked(() => showOverlay('chosen', marks));
  });
}
