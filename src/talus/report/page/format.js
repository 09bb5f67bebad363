'use strict';
// Words and numbers: units from the names of settings, figures rounded for reading. Nothing is computed here but units.

// The end of a setting's name says its unit; longer ends come first.
const unitsByEnding = [
  ['_m_s2', 'm/s²'], ['_kg_m3', 'kg/m³'], ['_deg_s', '°/s'], ['_rad_s', 'rad/s'], ['_m_s', 'm/s'], ['_per_s', '1/s'],
  ['_kJ', 'kJ'], ['_J', 'J'], ['_kg', 'kg'], ['_m3', 'm³'], ['_deg', '°'], ['_s', 's'], ['_m', 'm'],
];

function unitOf(key) {
  const found = unitsByEnding.find(([ending]) => key.endsWith(ending));
  return found ? found[1] : '';
}

// "normal_velocity_cutoff_m_s" reads "Normal velocity cutoff".
function wordsOf(key) {
  const found = unitsByEnding.find(([ending]) => key.endsWith(ending));
  const words = (found ? key.slice(0, -found[0].length) : key).replace(/_/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

// Thousands are set apart; a missing value is a dash.
function number(value, digits = 6) {
  if (value === null || value === undefined || value === '') return '–';
  if (typeof value !== 'number') return String(value);
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e15) return value.toLocaleString('en-US').replace('-', '−');
  if (size < 1e-4 || size >= 1e15) return value.toExponential(Math.max(digits - 3, 1)).replace('-', '−');
  const decimals = Math.min(Math.max(digits - 1 - Math.floor(Math.log10(size)), 0), 9);
  return value.toLocaleString('en-US', {maximumFractionDigits: decimals}).replace('-', '−');
}

// A result, with as many digits as it deserves: four, and none beyond a thousandth of its unit but the first one. Less
// than a millionth is what is left of rounding.
function measured(value, digits = 4) {
  if (!isNumber(value) || Number.isInteger(value)) return number(value);
  const first = -Math.floor(Math.log10(Math.abs(value)));
  const decimals = first > 6 ? 0 : first > 3 ? first : Math.min(Math.max(digits - 1 + first, 0), 3);
  return (Number(value.toFixed(decimals)) || 0).toLocaleString('en-US', {maximumFractionDigits: decimals}).replace('-', '−');
}

const metres = (value) => number(value, 5) + ' m';
const kJ = (joules) => joules === null || joules === undefined ? null : joules / 1000;
const count = (n, one, many = one + 's') => `${number(n)} ${n === 1 ? one : many}`;

// Axis ticks: true minus sign, thousands set apart, no more decimals than the step needs.
function tickText(scale, ticks) {
  const values = scale.ticks(ticks);
  const step = values.length > 1 ? Math.abs(values[1] - values[0]) : 1;
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return (v) => v.toLocaleString('en-US', {minimumFractionDigits: decimals, maximumFractionDigits: decimals}).replace('-', '−');
}

// A property as the manual's tables give it: a number, or a mean with its distribution.
function property(value) {
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

function settingText(value) {
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

// Words to choose from; names and files of the user stay as they are.
const choiceWords = Object.fromEntries(['lumped_mass', 'rigid_sphere', 'closed_form', 'tangential_restitution', 'monte_carlo',
  'latin_hypercube', 'per_impact', 'per_rock'].map((word) => [word, word.replace(/_/g, ' ')]));

const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

// A capital in front; a run's name, which comes first where there are two, stays as it is.
const startOfSentence = (text) => single ? text.charAt(0).toUpperCase() + text.slice(1) : text;
