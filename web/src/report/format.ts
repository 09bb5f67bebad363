// Text of numbers, units and settings. Results are rounded for reading; nothing is computed except unit conversions.
// Numbers of the page's data are metric. Each result is shown by the unit that it has there, in the units that the reader
// chose; inputs and saved tables stay metric.

import type { Setting } from '../archive/summary';
import * as d3 from '../figures/d3';
import type { Scale } from '../figures/plot';
import { rockModels } from '../figures/rockModels';
import { measured as measuredText, numberText } from '../units/numbers';
import { displayedIn, type UnitSystem } from '../units/units';

export let unitSystem: UnitSystem = 'metric';
export function showIn(system: UnitSystem) {
  unitSystem = system;
}

export const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);

/// What is shown for a unit of the data, and the size of one.
export const displayOf = (unit: string) => displayedIn(unitSystem, unit);
export const unitIn = (unit: string) => displayOf(unit).unit;
export const amountIn = (unit: string, value: number) => value / displayOf(unit).per;

/// The scale of an axis in the displayed unit, for one in the unit of the data.
export const axisIn = (unit: string, scale: Scale): Scale =>
  d3
    .scaleLinear()
    .domain(scale.domain().map((end) => amountIn(unit, end)))
    .range(scale.range());

// Units by the ending of a setting's name, the longer endings first.
const unitsByEnding = [
  ['_m_s2', 'm/s²'],
  ['_kg_m3', 'kg/m³'],
  ['_kg_s', 'kg/s'],
  ['_deg_s', '°/s'],
  ['_rad_s', 'rad/s'],
  ['_m_s', 'm/s'],
  ['_per_s', '1/s'],
  ['_kJ', 'kJ'],
  ['_J', 'J'],
  ['_kg', 'kg'],
  ['_m3', 'm³'],
  ['_deg', '°'],
  ['_s', 's'],
  ['_m', 'm'],
] as const;
const endingOf = (key: string) => unitsByEnding.find(([ending]) => key.endsWith(ending));

export const unitOf = (key: string) => endingOf(key)?.[1] ?? '';

/// "normal_velocity_cutoff_m_s" is shown as "Normal velocity cutoff".
export function wordsOf(key: string): string {
  const ending = endingOf(key)?.[0] ?? '';
  const words = key.slice(0, key.length - ending.length).replace(/_/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/// A setting with up to `digits` significant digits; a dash if it is missing.
export function number(value: number | string | null | undefined, digits = 6): string {
  if (value === null || value === undefined || value === '') return '–';
  return typeof value === 'number' ? numberText(value, digits) : value;
}

/// A result, rounded to the digits that matter; a dash if it is missing.
export const measured = (value: number | null | undefined, digits?: number) =>
  isNumber(value) ? measuredText(value, digits) : '–';

/// Results with a unit of the data: without and with the displayed unit.
export const resultIn = (unit: string, value: number | null | undefined, digits?: number) =>
  measured(isNumber(value) ? amountIn(unit, value) : null, digits);
export const lengthText = (metres: number) => `${resultIn('m', metres, 5)} ${unitIn('m')}`;
export const energyText = (joules: number) => `${resultIn('J', joules)} ${unitIn('J')}`;
/// A round length or energy of the data, such as a height that was given, whose other units are not round.
export const givenIn = (unit: string, value: number | null | undefined, digits = 6) =>
  number(isNumber(value) ? amountIn(unit, value) : null, unitSystem === 'metric' ? digits : 4);
export const givenLength = (metres: number, digits?: number) => `${givenIn('m', metres, digits)} ${unitIn('m')}`;

/// Saved tables are metric, with kJ.
export const inSavedUnit = (unit: string, value: number | null | undefined) =>
  isNumber(value) ? value / displayedIn('metric', unit).per : null;
export const kJ = (joules: number | null | undefined) => inSavedUnit('J', joules);
export const count = (n: number, one: string, many = `${one}s`) => `${number(n)} ${n === 1 ? one : many}`;

export const isList = (value: Setting): value is readonly Setting[] => Array.isArray(value);
type Entries = Readonly<Record<string, Setting>>;

/// A property as in the tables of the verification manual: a number, or a mean with its distribution.
export function property(value: Setting): string {
  if (value === null || value === undefined) return '–';
  if (isNumber(value)) return number(value);
  if (typeof value !== 'object' || isList(value) || !('mean' in value)) return settingText(value);
  const of = value as Entries;
  const kind = String(of.distribution || of.kind || 'none');
  const shown = (part: Setting) => number(isNumber(part) ? part : null);
  if (kind === 'none') return shown(of.mean);
  let text = `${shown(of.mean)}, ${kind}`;
  if (isNumber(of.std_dev)) text += `, σ ${number(of.std_dev)}`;
  if (isNumber(of.rel_min) || isNumber(of.rel_max)) text += `, −${shown(of.rel_min)} / +${shown(of.rel_max)}`;
  return text;
}

export function settingText(value: Setting): string {
  if (value === true) return 'yes';
  if (value === false) return 'no';
  if (value === null || value === undefined) return 'not given';
  if (typeof value === 'number') return number(value, 8);
  if (typeof value === 'string') return choiceWords[value] ?? value;
  if (isList(value)) {
    if (value.every((each) => typeof each !== 'object')) {
      return value.map((each) => (isNumber(each) || typeof each === 'string' ? number(each) : settingText(each))).join(', ');
    }
    return value.map((each) => (isList(each) ? `(${settingText(each)})` : settingText(each))).join(' ');
  }
  if ('mean' in value) return property(value);
  return Object.entries(value)
    .map(([key, each]) => `${wordsOf(key).toLowerCase()} ${settingText(each)}`)
    .join(', ');
}

// Words of enumerations. Names and files of the user stay as they are.
const choiceWords: Record<string, string> = {
  ...rockModels,
  ...Object.fromEntries(
    ['closed_form', 'tangential_restitution', 'monte_carlo', 'latin_hypercube', 'per_impact', 'per_rock'].map((word) => [
      word,
      word.replace(/_/g, ' '),
    ]),
  ),
};
