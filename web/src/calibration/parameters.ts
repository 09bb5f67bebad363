// The numbers of a project that a calibration may seek, with suggested ranges.

import type { LibraryMaterial } from '../api/types';
import type { Range } from '../settings/schema';
import { tableOf } from '../settings/declared';
import { hasEffect } from '../settings/conditions';
import type { TomlTable } from '../toml/format';

export interface Candidate {
  path: string;
  title: string;
  range: [number, number];
}

const meanOf = (value: unknown): number | undefined => {
  const number = typeof value === 'object' && value !== null ? (value as { mean?: unknown }).mean : value;
  return typeof number === 'number' && Number.isFinite(number) ? number : undefined;
};
/// A material in a path, by its name where that can be written.
const partOf = (name: string, index: number) =>
  name === '' || name.includes('"') ? String(index) : name.includes('.') ? `"${name}"` : name;
const rounded = (value: number) => Number(value.toPrecision(3));

/// The range of published values; without them what the setting may be, or from half to twice the present value.
export function suggestedRange(published: readonly number[], now: number | undefined, legal: Range): [number, number] {
  const known = now === undefined ? [...published] : [...published, now];
  const [low, high] = [Math.min(...known), Math.max(...known)];
  if (new Set(published).size > 1) return [low, high];
  if (legal.least !== undefined && legal.most !== undefined && !legal.leastExcluded && !legal.mostExcluded)
    return [legal.least, legal.most];
  const middle = now || 1;
  const within = (value: number) => Math.min(Math.max(value, legal.least ?? -Infinity), legal.most ?? Infinity);
  return [rounded(within(middle / 2)), rounded(within(middle * 2))];
}

/// The numbers of all materials that have an effect in the project.
export function candidatesOf(project: TomlTable, library: readonly LibraryMaterial[]): Candidate[] {
  const rows = Array.isArray(project.material) ? (project.material as TomlTable[]) : [];
  const defaultOf = (table: string, key: string) => tableOf(table)?.fields.find((field) => field.key === key)?.default;
  const fields = (tableOf('material')?.fields ?? []).filter(
    ({ type }) => type.kind === 'distribution' || type.kind === 'number',
  );
  return rows.flatMap((row, index) => {
    const name = typeof row.name === 'string' ? row.name : '';
    const like = library.find(({ key }) => key === row.like)?.values ?? {};
    return fields
      .filter(({ needs }) => hasEffect(needs, 'material', row, project, defaultOf))
      .map(({ key, title, unit, type, default: usual }) => {
        const published = library.flatMap(({ values }) => meanOf(values[key]) ?? []);
        const now = meanOf(row[key]) ?? meanOf(like[key]) ?? meanOf(usual);
        const legal = 'range' in type ? type.range : {};
        return {
          path: `material.${partOf(name, index)}.${key}`,
          title: `${name || `material ${index + 1}`}: ${title.toLowerCase()}${unit ? `, ${unit}` : ''}`,
          range: suggestedRange(published, now, legal),
        };
      });
  });
}
