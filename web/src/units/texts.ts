// Decimals, sizes and times as text. What figures need, too, is in numbers.ts.

import { numberText } from './numbers';

/// "3:05", "1:02:03".
export function clockText(seconds: number): string {
  const whole = Math.round(seconds);
  const two = (n: number) => String(n).padStart(2, '0');
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}

/// The number of decimals for the values of a column: five significant digits of their range, at most four decimals.
export function decimalsOf(values: readonly number[]): number {
  const known = values.filter(Number.isFinite);
  const [low, high] = known.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity]);
  if (known.every(Number.isInteger)) return 0;
  const size = high > low ? high - low : Math.abs(high);
  return Math.min(Math.max(4 - Math.floor(Math.log10(size)), 0), 4);
}

/// A number text divided by 10 to the power `places`, with the same digits: "152.5304" for "152530.4" and 3 places.
export function shiftedText(text: string, places: number): string {
  const parts = /^([+-]?)(\d+)(?:\.(\d*))?(?:e([+-]?\d+))?$/i.exec(text);
  if (!parts || places === 0) return text;
  const [, sign = '', whole = '', decimals = '', exponent] = parts;
  if (exponent !== undefined) return `${sign}${whole}${decimals && `.${decimals}`}e${Number(exponent) - places}`;
  const digits = `${'0'.repeat(Math.max(0, places + 1 - whole.length))}${whole}`;
  const point = digits.length - places;
  const behind = `${digits.slice(point)}${decimals}`.replace(/0+$/, '');
  return `${sign}${digits.slice(0, point)}${behind && `.${behind}`}`;
}

/// A number text divided by `per`: with the same digits if that is a power of ten.
export function dividedText(text: string, per: number): string {
  const power = Math.log10(per);
  if (Number.isInteger(power)) return shiftedText(text, power);
  const value = Number(text);
  return text === '' || !Number.isFinite(value) ? text : String(Number((value / per).toPrecision(15)));
}

/// "2.3 MB".
export function bytesText(bytes: number): string {
  const units = ['bytes', 'kB', 'MB', 'GB', 'TB'];
  const k = Math.min(bytes < 1000 ? 0 : Math.floor(Math.log10(bytes) / 3), units.length - 1);
  return `${numberText(bytes / 1000 ** k, 3)} ${units[k]}`;
}

/// A time in the user's time zone: "21 Nov, 11:05".
export function momentText(iso: string): string {
  const moment = new Date(iso);
  if (Number.isNaN(moment.getTime())) return iso;
  const isThisYear = moment.getFullYear() === new Date().getFullYear();
  return moment.toLocaleString('en-GB', {
    day: 'numeric',
    month: 'short',
    ...(!isThisYear && { year: 'numeric' }),
    hour: '2-digit',
    minute: '2-digit',
  });
}
