// The units in which results are shown.

import type { ReadonlySignal } from '@preact/signals';
import { displayedIn, type Displayed, type UnitSystem } from '../units/units';
import { kept } from './kept';

const system = kept<UnitSystem>('units', 'metric');
export const unitSystem: ReadonlySignal<UnitSystem> = system;
export const switchUnits = () => void (system.value = system.peek() === 'metric' ? 'US customary' : 'metric');

/// How numbers in a unit of the files are shown.
export const displayOf = (unit: string): Displayed => displayedIn(unitSystem.value, unit);
