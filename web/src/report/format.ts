// Text of numbers, units and settings. Results are rounded for reading; nothing is computed except unit conversions.
// Numbers of the page's data are metric. Each result is shown by the unit that it has there, in the units that the reader
// chose; inputs and saved tables stay metric.

import * as d3 from '../figures/d3';
import * as figures from '../figures/report';

export let unitSystem = 'metric';
export function showIn(system) {
  unitSystem = system;
}
export const displayOf = (unit) => figures.displayedIn(unitSystem, unit);  // {unit, per}: what is shown, and the size of one
export const unitIn = (unit) => displayOf(unit).unit;
export const amountIn = (unit, value) => isNumber(value) ? value / displayOf(unit).per : value;

// The scale of an axis in the displayed unit, for one in the unit of the data.
export const axisIn = (unit, scale) => d3.scaleLinear().domain(scale.domain().map((end) => amountIn(unit, end))).range(scale.range());

// Units by the ending of a setting's name, the longer endings first.
const unitsByEnding = [
  ['_m_s2', 'm/s²'], ['_kg_m3', 'kg/m³'], ['_kg_s', 'kg/s'], ['_deg_s', '°/s'], ['_rad_s', 'rad/s'], ['_m_s', 'm/s'], ['_per_s', '1/s'],
  ['_kJ', 'kJ'], ['_J', 'J'], ['_kg', 'kg'], ['_m3', 'm³'], ['_deg', '°'], ['_s', 's'], ['_m', 'm'],
];

export function unitOf(key) {
  const found = unitsByEnding.find(([ending]) => key.endsWith(ending));
  return found ? found[1] : '';
}

// "normal_velocity_cutoff_m_s" is shown as "Normal velocity cutoff".
export function wordsOf(key) {
  const found = unitsByEnding.find(([ending]) => key.endsWith(ending));
  const words = (found ? key.slice(0, -found[0].length) : key).replace(/_/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

// A setting with up to `digits` significant digits; a dash if it is missing.
export function number(value, digits = 6) {
  if (value === null || value === undefined || value === '') return '–';
  return typeof value === 'number' ? figures.numberText(value, digits) : String(value);
}

// A result, rounded to the digits that matter.
export const measured = (value, digits) => isNumber(value) ? figures.measured(value, digits) : number(value);

// Results with a unit of the data: without and with the displayed unit.
export const resultIn = (unit, value, digits) => measured(amountIn(unit, value), digits);
export const lengthText = (metres) => `${resultIn('m', metres, 5)} ${unitIn('m')}`;
export const energyText = (joules) => `${resultIn('J', joules)} ${unitIn('J')}`;
// A round length or energy of the data, such as a height that was given, whose other units are not round.
export const givenIn = (unit, value, digits = 6) => number(amountIn(unit, value), unitSystem === 'metric' ? digits : 4);
export const givenLength = (metres, digits) => `${givenIn('m', metres, digits)} ${unitIn('m')}`;

// Saved tables are metric, with kJ.
export const inSavedUnit = (unit, value) => isNumber(value) ? value / figures.displayedIn('metric', unit).per : null;
export const kJ = (joules) => inSavedUnit('J', joules);
export const count = (n, one, many = one + 's') => `${number(n)} ${n === 1 ? one : many}`;

// A property as in the tables of the verification manual: a number, or a mean with its distribution.
export function property(value) {
  if (value === null || value === undefined) return '–';
  if (typeof value !== 'object') return number(value);
  if (!('mean' in value)) return settingText(value);
  const kind = value.distribution || value.kind || 'none';
  if (kind === 'none') return number(value.mean);
  let text = `${number(value.mean)}, ${kind}`;
  if (isNumber(value.std_dev)) text += `, σ ${number(value.std_dev)}`;
  if (isNumber(value.rel_min) || isNumber(value.rel_max)) {
    text += `, −${number(value.rel_min ?? null)} / +${number(value.rel_max ?? null)}`;
  }
  return text;
}

export function settingText(value) {
  if (value === true) return 'yes';
  if (value === false) return 'no';
  if (value === null || value === undefined) return 'not given';
  if (Array.isArray(value)) {
    const flat = value.every((v) => typeof v !== 'object');
    return flat ? value.map((v) => number(v)).join(', ') : value.map((v) => Array.isArray(v) ? `(${settingText(v)})` : settingText(v)).join(' ');
  }
  if (typeof value === 'object') {
    if ('mean' in value) return property(value);
    return Object.entries(value).map(([k, v]) => `${wordsOf(k).toLowerCase()} ${settingText(v)}`).join(', ');
  }
  return typeof value === 'number' ? number(value, 8) : choiceWords[value] || String(value);
}

// Words of enumerations. Names and files of the user stay as they are.
const choiceWords = Object.fromEntries(['lumped_mass', 'rigid_sphere', 'closed_form', 'tangential_restitution', 'monte_carlo',
  'latin_hypercube', 'per_impact', 'per_rock'].map((word) => [word, word.replace(/_/g, ' ')]));

export const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
