// Units for display. Files, settings, places and kits are metric always.

export type UnitSystem = 'metric' | 'US customary';

/// Numbers in the unit of the files are divided by `per` for display.
export interface Displayed {
  unit: string;
  per: number;
}

// Exact: NIST Special Publication 811 (2008), appendix B.8.
const foot = 0.3048; // [m]
const pound = 0.45359237; // [kg]
const gravity = 9.80665; // of the pound-force [m/s2]
const kipFoot = 1000 * pound * gravity * foot; // 1,000 ft lbf [J]

const tables: Record<UnitSystem, Readonly<Record<string, Displayed>>> = {
  metric: { J: { unit: 'kJ', per: 1000 } },
  'US customary': {
    m: { unit: 'ft', per: foot },
    'm/s': { unit: 'ft/s', per: foot },
    J: { unit: 'kip·ft', per: kipFoot },
    kJ: { unit: 'kip·ft', per: kipFoot / 1000 },
    kg: { unit: 'lb', per: pound },
  },
};

/// How numbers in a unit of the files are shown. Units that no table has are shown as they are; `share` in percent.
export function displayedIn(system: UnitSystem, unit: string): Displayed {
  if (unit === 'share') return { unit: '%', per: 0.01 };
  if (unit.endsWith('²')) {
    const { unit: root, per } = displayedIn(system, unit.slice(0, -1));
    return { unit: `${root}²`, per: per ** 2 };
  }
  return tables[system][unit] ?? { unit, per: 1 };
}
