// What a run was of, in few words for a sheet: its rock model, rocks and materials, from the project in its summary.

import { entriesIn } from '../archive/summary';
import { numberText } from '../units/numbers';
import { applies } from '../settings/applies';
import { constantKind, type KeyOf } from '../settings/names';
import { fieldOf } from '../settings/declared';
import { valueText, wordText } from '../settings/words';
import type { TomlTable, TomlValue } from '../toml/format';
import { modelName } from './models';

/// Numbers may be texts, with the digits of the file.
export type Echo = Record<string, unknown>;

export const isGiven = (value: unknown) => value !== undefined && value !== null;

/// "±0.015", "−0.6/+1.2"; limits are given from the mean.
function limitsText(low: unknown, high: unknown): string {
  const [below, above] = [low, high].map((each) => (isGiven(each) ? numberText(Number(each)) : null));
  if (below !== null && below === above) return `±${below}`;
  return [below !== null && `−${below}`, above !== null && `+${above}`].filter(Boolean).join('/');
}

/// "900 kg", "900 kg, lognormal, σ 500, ±400", "empirical, masses.csv".
export function drawnText(value: unknown, unit = ''): string {
  if (!isGiven(value)) return '';
  const inUnit = (text: string) => (unit && text ? `${text} ${unit}` : text);
  if (typeof value !== 'object') return inUnit(Number.isFinite(Number(value)) ? numberText(Number(value)) : String(value));
  const { mean, distribution, std_dev: deviation, rel_min: low, rel_max: high, file } = value as Echo;
  const kind = distribution && distribution !== constantKind ? wordText(String(distribution)) : '';
  const spread = kind !== '' && isGiven(deviation) && Number(deviation) !== 0 ? `σ ${drawnText(deviation)}` : '';
  const limits = kind !== '' ? limitsText(low, high) : '';
  return [drawnText(mean, unit), kind, spread, limits, typeof file === 'string' ? file : ''].filter(Boolean).join(', ');
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
  return `${title} ${drawnText(seeder[key], unit)}`;
}
/// "mass 900 kg, lognormal, σ 500; 2,700 kg/m³"
export const blocksText = (seeder: Echo): string => `${sizeText(seeder)}; ${drawnText(seeder.density_kg_m3)} kg/m³`;

export const modelOf = (project: Echo): string => modelName(String((project.analysis as Echo | undefined)?.model));

/// Choices of [analysis] that engineers ask for, if they have an effect.
const lawKeys: readonly (readonly [KeyOf<'analysis'>, string])[] = [
  ['laws', 'laws'],
  ['rotation', 'rotation'],
  ['sliding', 'sliding'],
  ['friction_angle', 'friction angle from'],
  ['roughness_law', 'roughness as'],
  ['scale_rn_by_velocity', 'Rn falls with velocity'],
  ['scale_rn_by_mass', 'Rn falls with mass'],
  ['tangential_crsp_damping', 'CRSP damping'],
  ['rolling_resistance_in_impacts', 'rolling resistance in impacts'],
];
/// "laws talus", "rotation yes", ...
export function lawsOf(project: Echo): string[] {
  const analysis = (project.analysis ?? {}) as Echo;
  return lawKeys
    .filter(([key]) => isGiven(analysis[key]) && applies(fieldOf('analysis', key)?.needs ?? [], 'analysis', analysis as TomlTable, project as Record<string, TomlValue>))
    .map(([key, title]) => `${title} ${valueText(analysis[key])}`);
}

const properties: readonly (readonly [KeyOf<'material'>, string])[] = [
  ['normal_restitution', 'Rn'],
  ['tangential_restitution', 'Rt'],
  ['friction_angle_deg', 'φ, °'],
  ['dynamic_friction', 'μ'],
  ['rolling_friction', 'μ rolling'],
  ['roughness_deg', 'roughness, °'],
  ['roughness_spacing_m', 'spacing, m'],
  ['roughness_amplitude_m', 'bumps, m'],
  ['ground_drag_per_s', 'drag, 1/s'],
  ['forest_drag_kg_s', 'forest, kg/s'],
];

/// The forests over the ground: "Spruce: medium, 18 m high".
export function forestsOf(project: Echo): string[] {
  return entriesIn(project, 'forest').map(({ name, density, drag_kg_s, height_m }) => {
    const drag = drag_kg_s === undefined || drag_kg_s === null ? (density === 'none' ? 'clearing' : String(density)) : `${drawnText(drag_kg_s)} kg/s`;
    return [`${String(name)}: ${drag}`, height_m !== undefined && height_m !== null && `${drawnText(height_m)} m high`].filter(Boolean).join(', ');
  });
}

/// A material with the values of the shown properties; "–": without an effect.
export interface MaterialRow {
  name: string;
  like: string;
  values: string[];
}
type Property = (typeof properties)[number];

/// The materials with their properties that have an effect.
export function materialsOf(project: Echo): { columns: readonly Property[]; rows: MaterialRow[] } {
  const materials = entriesIn(project, 'material');
  const hasEffect = (key: KeyOf<'material'>, row: Echo) =>
    row[key] !== undefined && row[key] !== null && applies(fieldOf('material', key)?.needs ?? [], 'material', row as TomlTable, project as Record<string, TomlValue>);
  // A property that is 0 everywhere says nothing.
  const columns = properties.filter(([key]) => materials.some((row) => hasEffect(key, row) && drawnText(row[key]) !== '0'));
  return {
    columns,
    rows: materials.map((row) => ({ name: String(row.name), like: typeof row.like === 'string' ? row.like : '', values: columns.map(([key]) => (hasEffect(key, row) ? drawnText(row[key]) : '–')) })),
  };
}

/// Where the values of a material are from: "as talus cover [1, 2]; φ default". `fromLibrary`: the keys of those that
/// are of the library, by sources with the numbers `marks`.
export function originText({ like, values }: MaterialRow, columns: readonly Property[], fromLibrary: ReadonlySet<string>, marks: readonly number[]): string {
  const others = columns.map(([key, title], k) => ({ key, name: title.split(',')[0]!, value: values[k] })).filter(({ key, value }) => value !== '–' && !fromLibrary.has(key));
  const isDefault = ({ key, value }: (typeof others)[number]) => value === drawnText(fieldOf('material', key)?.default);
  const [usual, own] = [others.filter(isDefault), others.filter((each) => !isDefault(each))].map((list) => list.map(({ name }) => name).join(', '));
  if (marks.length === 0) return [own && 'own values', usual && `${usual} default`].filter(Boolean).join('; ');
  return [`as ${wordText(like)} [${marks.join(', ')}]`, own && `${own} own`, usual && `${usual} default`].filter(Boolean).join('; ');
}
