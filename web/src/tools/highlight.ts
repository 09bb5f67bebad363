// Highlights the selected entry in the view.

import { effect, untracked } from '@preact/signals';
import { showOverlay, type Overlay } from './tool';
import { model } from '../project/model';
import { chosen } from '../project/chosen';
import { materialColour } from '../view/colours';

const forestColour = '#1b7837';

export function followChosen(): () => void {
  return effect(() => {
    const path = chosen.value?.join('.');
    const seeder = model.value?.seeders.find((one) => one.path === path);
    const barrier = model.value?.barriers.find((one) => one.path === path);
    const area = model.value?.areas.find((one) => one.path === path);
    const forest = model.value?.forests.find((one) => one.path === path);
    const marks: Overlay[] = [];
    for (const points of area?.sides ?? [])
      marks.push({ points, kind: 'line', colour: materialColour(area!.material), isBare: true });
    for (const points of forest?.sides ?? []) marks.push({ points, kind: 'line', colour: forestColour, isBare: true });
    if (seeder) {
      const kind = seeder.type === 'polygon' ? 'polygon' : 'line';
      for (const points of seeder.lines) marks.push({ points, kind, isBare: true });
      if (seeder.lines.length === 0) marks.push({ points: seeder.points.slice(0, 500), kind: 'points' });
    }
    for (const points of barrier ? [barrier.top, barrier.foot] : []) marks.push({ points, kind: 'line', isBare: true });
    untracked(() => showOverlay('chosen', marks));
  });
}
