// The legends of the section.

import { observedLegends } from '../calibration/observations';
import { pathLegends } from '../paths/pathLegends';
import { model } from '../project/model';
import { materialColour } from '../view/colours';
import type { LegendData } from '../view/legends';

export function sectionLegends(): LegendData[] {
  const kinds = (model.value?.materials ?? []).map((name, k) => ({ name, colour: materialColour(k) }));
  return [...pathLegends(), ...observedLegends(), ...(kinds.length > 0 ? [{ kind: 'kinds' as const, title: 'Material', kinds }] : [])];
}
