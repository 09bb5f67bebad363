// Which inputs what if varies, by how much, and of which material: kept by the browser for each project.

import { computed } from '@preact/signals';
import type { WhatIfChoices, WhatIfOptions } from '../api/whatIf';
import { typedNumber } from '../settings/numbers';
import { keptOfProject } from '../project/ofProject';
import { owned } from '../state/owned';

/// By factor what differs from the usual step: what was typed, or false if it is left out.
export type ChosenSteps = Readonly<Record<string, string | false>>;

export const [material, chooseMaterial] = owned(keptOfProject<string>('material of what if', ''));
const keptSteps = keptOfProject<string>('steps of what if', '{}');
export const chosenSteps = computed(() => JSON.parse(keptSteps.value) as ChosenSteps);

/// Undefined: the usual step.
export function chooseStep(factor: string, step: string | false | undefined) {
  const { [factor]: before, ...others } = chosenSteps.peek();
  keptSteps.value = JSON.stringify(step === undefined ? others : { ...others, [factor]: step });
}

export const isLeftOut = (of: ChosenSteps, factor: string) => of[factor] === false;

/// As in a request; the engine refuses what is not a number or out of range. Null: every input is left out.
export function optionsOf({ factors }: WhatIfChoices, chosen: ChosenSteps, ofMaterial: string): WhatIfOptions | null {
  const taken = factors.filter(({ factor }) => !isLeftOut(chosen, factor));
  if (taken.length === 0) return null;
  const isUsual = factors.every(({ factor }) => chosen[factor] === undefined);
  const steps = taken.map(({ factor, usual_percent }) => {
    const typed = chosen[factor];
    return [factor, typeof typed === 'string' ? (typedNumber(typed) ?? '') : usual_percent] as const;
  });
  return { ...(ofMaterial !== '' && { material: ofMaterial }), ...(!isUsual && { steps: Object.fromEntries(steps) }) };
}
