// The stretch of a line that asks for the most energy.

import type { LineAnswer, LineFigures } from '../api/line';
import type { Overlay } from '../tools/tool';
import { markColours } from '../view/colours';
import { displayOf } from '../state/displayUnits';
import { counted, numberText } from '../units/numbers';
import { partOf } from './foot';

/// Null: the line is one stretch, or no rock crosses.
export function worstOf({ worst, sections }: LineAnswer): LineFigures | null {
  return worst && sections.length > 1 ? (sections[worst.section] ?? null) : null;
}

/// "from 40 to 60 m: class 4, 1,230 kJ, 3.4 m, 18 rocks"
export function worstText({ from_m, to_m, needs, rocks }: LineFigures, standard: string | null): string {
  const text = (metric: string, value: number, digits = 3) => numberText(value / displayOf(metric).per, digits);
  const [energy, height] = needs ? ([['J', needs.energy_J], ['m', needs.height_m]] as const).map(([metric, value]) => `${text(metric, value)} ${displayOf(metric).unit}`) : []; // prettier-ignore
  const fence = [needs && standard !== null && `class ${needs.class}`, energy, height, counted(rocks, 'rock')];
  return `from ${text('m', from_m)} to ${text('m', to_m)} ${displayOf('m').unit}: ${fence.filter(Boolean).join(', ')}`;
}

/// Marks it in the views.
export function worstOverlay(of: LineAnswer): Overlay[] {
  const worst = worstOf(of);
  if (!worst) return [];
  const points = partOf(of.foot, worst.from_m, worst.to_m);
  return points.length > 1 ? [{ points, kind: 'line', colour: markColours.worst, isBare: true, width: 6, place: { name: 'worst stretch', isFitted: false } }] : [];
}
