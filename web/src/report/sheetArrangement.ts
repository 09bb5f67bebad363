// Where plan and section are on the sheet.

import { drawing } from './figure';
import { mapRoom, mapScaleIn } from './mapRoom';
import { plan } from './plan';
import { paperName, papers } from './run';
import { sectionScaleIn } from './sectionFigure';
import { slope } from './slope';

/// Denominators.
export interface Scales {
  plan: number;
  section: number;
}
/// In drawing units.
interface Place {
  wide: number;
  tall: number;
}
interface Arrangement {
  plan: Place;
  section: Place;
  isBeside: boolean;
}

export const unitsOf = (mm: number) => mm / drawing.mmOnPaper;
const wide = unitsOf(papers[paperName].mm);
const note = 112; // axis, legend and scale below a frame

const below = (tall: number, share: number): Arrangement => ({
  plan: { wide, tall: share * tall - note },
  section: { wide, tall: (1 - share) * tall - note },
  isBeside: false,
});
const beside = (tall: number, share: number): Arrangement => ({
  plan: { wide: share * wide - 12, tall: tall - note },
  section: { wide: (1 - share) * wide - 12, tall: tall - note },
  isBeside: true,
});
const alone = (tall: number): Arrangement => {
  const all = { wide, tall: tall - note };
  return { plan: all, section: all, isBeside: false };
};

const scalesOf = ({ plan: ofPlan, section: ofSection }: Arrangement): Scales => ({
  plan: plan ? mapScaleIn(mapRoom(ofPlan.wide, ofPlan.tall), plan.views[plan.opens]) : 1,
  section: slope ? sectionScaleIn(slope, ofSection.wide, ofSection.tall) : 1,
});

/// Below each other, or beside each other on a wide page, whichever gives the larger scales, by their product.
export function arrangementIn(tall: number): Arrangement & { scales: Scales } {
  const withScales = (each: Arrangement) => ({ ...each, scales: scalesOf(each) });
  if (!plan || !slope) return withScales(alone(tall));
  const others = [
    ...[0.6, 0.7, 0.4, 0.3].map((share) => below(tall, share)),
    ...(wide > 2 * drawing.wide ? [0.5, 0.6, 0.4].map((share) => beside(tall, share)) : []),
  ];
  const size = ({ scales }: { scales: Scales }) => scales.plan * scales.section;
  const first = withScales(below(tall, 0.5));
  return others.map(withScales).reduce((best, each) => (size(each) < size(best) ? each : best), first);
}
