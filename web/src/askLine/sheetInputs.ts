// What a run was of, in few words for a sheet: its rock model, rocks and materials, from the project in its summary.

import { numberText } from '../units/numbers';
import { applies } from '../settings/applies';
import { constantKind, type KeyOf } from '../settings/names';
import { fieldOf } from '../settings/declared';
import { wordText } from '../settings/words';
import type { TomlTable, TomlValue } from '../toml/format';

/// Numbers may be texts, with the digits of the file.
export type Echo = Record<string, unknown>;

const tablesOf = (project: Echo, key: string): Echo[] => (Array.isArray(project[key]) ? (project[key] as Echo[]) : []);

/// "900", "900, lognormal, σ 500", "empirical, masses.csv".
export function drawnText(value: unknown): string {
  if (value === null || value === undefined) return '';
  if (typeof value !== 'object') return Number.isFinite(Number(value)) ? numberText(Number(value)) : String(value);
  const { mean, distribution, std_dev: deviation, file } = value as Echo;
  const kind = distribution && distribution !== constantKind ? wordText(String(distribution)) : '';
  const spread = kind !== '' && deviation !== undefined && deviation !== null && Number(deviation) !== 0 ? `σ ${drawnText(deviation)}` : '';
  return [drawnText(mean), kind, spread, typeof file === 'string' ? file : ''].filter(Boolean).join(', ');
}

const sizes: readonly (readonly [KeyOf<'seeder'>, string, string])[] = [
  ['mass_kg', 'mass', 'kg'],
  ['volume_m3', 'volume', 'm³'],
  ['diameter_m', 'diameter', 'm'],
];

function sizeText(seeder: Echo): string {
  const found = sizes.find(([key]) => seeder[key] !== undefined && seeder[key] !== null);
  if (!found) return 'sizes of its table';
  const [key, title, unit] = found;
  const [first = '', ...more] = drawnText(seeder[key]).split(', ');
  return [`${title} ${first} ${unit}`, ...more].join(', ');
}

/// "Crest: mass 900 kg, lognormal, σ 500; 2,700 kg/m³"
export const rocksOf = (project: Echo): string[] =>
  tablesOf(project, 'seeder').map((seeder) => `${String(seeder.name)}: ${sizeText(seeder)}; ${drawnText(seeder.density_kg_m3)} kg/m³`);

export const modelOf = (project: Echo): string => wordText(String((project.analysis as Echo | undefined)?.model ?? ''));

const properties: readonly (readonly [KeyOf<'material'>, string])[] = [
  ['normal_restitution', 'Rn'],
  ['tangential_restitution', 'Rt'],
  ['friction_angle_deg', 'φ, °'],
  ['dynamic_friction', 'μ'],
  ['rolling_friction', 'μ rolling'],
  ['roughness_deg', 'roughness, °'],
];

/// The materials with their properties that have an effect.
export function materialsOf(project: Echo): { columns: string[]; rows: { name: string; values: string[] }[] } {
  const materials = tablesOf(project, 'material');
  const hasEffect = (key: KeyOf<'material'>, row: Echo) =>
    row[key] !== undefined && row[key] !== null && applies(fieldOf('material', key)?.needs ?? [], 'material', row as TomlTable, project as Record<string, TomlValue>);
  const shown = properties.filter(([key]) => materials.some((row) => hasEffect(key, row)));
  return {
    columns: shown.map(([, title]) => title),
    rows: materials.map((row) => ({ name: String(row.name), values: shown.map(([key]) => (hasEffect(key, row) ? drawnText(row[key]) : '–')) })),
  };
}
