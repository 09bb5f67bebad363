// Ranges, defaults and values of settings as text.

import { constantKind } from './names';
import type { Field, Range } from './schema';

/// A word of the file for display: "lumped mass".
export const wordText = (word: string) => word.replaceAll('_', ' ');

/// "0 to 1", "more than 0", "0 or more"; empty if every number is allowed.
export function rangeText({ least, most, leastExcluded, mostExcluded }: Range): string {
  const low = leastExcluded ? `more than ${least}` : `${least} or more`;
  const high = mostExcluded ? `less than ${most}` : `at most ${most}`;
  if (least !== undefined && most !== undefined)
    return leastExcluded || mostExcluded ? `${low}, ${high}` : `${least} to ${most}`;
  return least !== undefined ? low : most !== undefined ? high : '';
}

/// A default for display: "0.35", "yes", "1, 0, 0".
export function valueText(value: unknown): string {
  if (value === undefined) return '';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'string') return wordText(value);
  if (Array.isArray(value)) return value.map(valueText).join(', ');
  if (typeof value === 'object' && value !== null && 'mean' in value) {
    const { mean, distribution } = value as { mean: unknown; distribution?: string };
    return distribution && distribution !== constantKind ? `${valueText(mean)}, ${distribution}` : valueText(mean);
  }
  return value === Infinity ? 'unlimited' : String(value);
}

/// What applies if a setting is not given: "default 0.35", "required", or a sentence.
export function absentText(field: Field): string {
  if (field.default !== undefined) return `default ${valueText(field.default)}`;
  if (field.required) return 'required';
  if (field.withoutIt) return field.withoutIt.replaceAll('`', '');
  return field.infinite ? 'default unlimited' : '';
}
