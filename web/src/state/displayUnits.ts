// The units in which results are shown.

import { displayedIn, type Displayed, type UnitSystem } from '../units/units';
import { kept } from './kept';

export const unitSystem = kept<UnitSystem>('units', 'metric');

/// How numbers in a unit of the files are shown.
export const displayOf = (unit: string): Displayed => displayedIn(unitSystem.value, unit);
