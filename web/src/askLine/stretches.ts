// The stretches of a line that ask for the strongest and for the highest fence.

import type { LineAnswer, LineFigures, Needs } from '../api/line';
import type { Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { displayOf } from '../state/displayUnits';
import { counted, numberText } from '../units/numbers';
import { partOf } from './foot';

type Stretch = LineFigures & { needs: Needs };
/// What it needs more of than all others: "energy", "height", "energy and height".
export interface MostNeeded {
  what: string;
  stretch: Stretch;
}

/// Empty: the line is one stretch, or no rock crosses.
export function mostNeeded({ sections }: Pick<LineAnswer, 'sections'>): MostNeeded[] {
  const known = sections.filter((each): each is Stretch => each.needs !== null);
  if (sections.length < 2 || known.length === 0) return [];
  const most = (key: keyof Needs) => known.reduce((a, b) => (b.needs[key] > a.needs[key] ? b : a));
  const [energy, height] = [most('energy_J'), most('height_m')];
  if (energy === height) return [{ what: 'energy and height', stretch: energy }];
  return [{ what: 'energy', stretch: energy }, { what: 'height', stretch: height }]; // prettier-ignore
}

/// "The most energy is needed from 40 to 60 m (18 rocks), the most height from 80 to 100 m (9 rocks)"
export function mostNeededText(of: readonly MostNeeded[]): string {
  const { unit, per } = displayOf('m');
  const texts = of.map(({ what, stretch }) => {
    const [from, to] = [stretch.from_m, stretch.to_m].map((each) => numberText(each / per, 3));
    return `most ${what} from ${from} to ${to} ${unit} (${counted(stretch.rocks, 'rock')})`;
  });
  return texts.join(', ');
}

/// Marks them in the views.
export function mostNeededOverlays(of: LineAnswer): Overlay[] {
  return mostNeeded(of).flatMap(({ what, stretch }): Overlay[] => {
    const points = partOf(of.foot, stretch.from_m, stretch.to_m);
    return points.length > 1 ? [{ points, kind: 'line', colour: markColours.worst, isBare: true, width: 6, place: { name: `most ${what}`, isFitted: false } }] : [];
  });
}
