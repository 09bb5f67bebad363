import { describe, expect, test } from 'vitest';
import { tablesOf } from './schema';
import { titleOf, unitText } from './titles';
import { absentText, rangeText, valueText } from './words';

const distribution = {
  type: 'object',
  properties: {
    mean: { type: 'number' },
    distribution: { enum: ['none', 'normal'] },
    std_dev: { type: 'number', minimum: 0 },
  },
};
const schema = {
  type: 'object',
  required: ['material'],
  properties: {
    name: { type: 'string', description: 'Its name.' },
    terrain: {
      type: 'object',
      properties: {
        section: {
          type: 'array',
          items: { type: 'array', items: { type: 'number' }, minItems: 2, maxItems: 2 },
          'x-excludes': ['mesh'],
        },
        mesh: { type: 'string', 'x-file': true, 'x-without-it': 'one of `section`, `mesh`, `polylines_m` and `"all"` is required' },
        polylines: {
          type: 'array',
          items: { type: 'array', items: { type: 'array', items: { type: 'number' }, minItems: 3, maxItems: 3 } },
        },
        rotate_about: { type: 'array', items: { type: 'number' }, minItems: 3, maxItems: 3, default: [0, 0, 0] },
        heading: {
          anyOf: [{ type: 'array', items: { type: 'number' }, minItems: 2, maxItems: 3 }, { const: 'downslope' }],
        },
      },
    },
    material: {
      type: 'array',
      items: {
        type: 'object',
        required: ['name'],
        properties: {
          name: { type: 'string' },
          friction_angle_deg: {
            anyOf: [{ type: 'number', minimum: 0, exclusiveMaximum: 90 }, distribution],
            'x-unit': 'deg',
            default: { mean: 30, distribution: 'none' },
          },
        },
      },
    },
    output: {
      type: 'object',
      properties: {
        paths: { anyOf: [{ enum: ['all', 'none'] }, { type: 'integer', minimum: 0 }], default: 'all' },
        percentiles: { type: 'array', items: { type: 'number' }, minItems: 0, maxItems: 20 },
        maps: {
          anyOf: [{ type: 'boolean' }, { type: 'array', items: { enum: ['passages', 'velocity'] }, uniqueItems: true }],
          default: true,
          maxItems: 8,
        },
      },
    },
  },
};
const tables = tablesOf(schema);
const field = (table: string, key: string) =>
  tables.find((one) => one.key === table)!.fields.find((one) => one.key === key)!;

describe('tables and fields of the schema', () => {
  test('keys before the first table form a table without a key', () => {
    expect(tables.map(({ key, repeated }) => [key, repeated])).toEqual([
      ['', false],
      ['terrain', false],
      ['material', true],
      ['output', false],
    ]);
    expect(field('', 'name').description).toBe('Its name.');
  });
  test('kinds of values', () => {
    expect(field('terrain', 'section').type).toMatchObject({ kind: 'rows', columns: 2 });
    expect(field('terrain', 'section').excludes).toEqual(['mesh']);
    expect(field('terrain', 'mesh').type.kind).toBe('file');
    expect(field('terrain', 'polylines').type).toEqual({ kind: 'lists of rows', columns: 3 });
    expect(field('terrain', 'rotate_about').type).toMatchObject({ kind: 'tuple', least: 3, most: 3, instead: [] });
    expect(field('terrain', 'heading').type).toMatchObject({ kind: 'tuple', least: 2, most: 3, instead: ['downslope'] });
    expect(field('output', 'paths').type).toMatchObject({
      kind: 'word or number',
      words: ['all', 'none'],
      whole: true,
    });
    expect(field('output', 'percentiles').type).toEqual({ kind: 'list', of: 'number' });
    expect(field('output', 'maps').type).toEqual({ kind: 'words', words: ['passages', 'velocity'] });
  });
  test('a random property', () => {
    const friction = field('material', 'friction_angle_deg');
    expect(friction).toMatchObject({ title: 'Friction angle', unit: '°' });
    expect(friction.type).toMatchObject({ kind: 'distribution', range: { least: 0, most: 90, mostExcluded: true } });
    expect(absentText(friction)).toBe('default 30');
    expect(absentText(field('material', 'name'))).toBe('required');
    // With the titles of other settings, not their keys.
    expect(absentText(field('terrain', 'mesh'))).toBe('one of section, mesh, polylines_m and "all" is required');
  });
});

test('titles and units', () => {
  expect(titleOf('normal_velocity_cutoff_m_s', 'm/s')).toBe('Normal velocity cutoff');
  expect(titleOf('ground_drag_per_s', '1/s')).toBe('Ground drag');
  expect(titleOf('density_kg_m3', 'kg/m3')).toBe('Density');
  expect(unitText('kg/m3')).toBe('kg/m³');
  expect(unitText('m/s2')).toBe('m/s²');
  expect(unitText('deg/s')).toBe('°/s');
});

test('ranges', () => {
  expect(rangeText({ least: 0, most: 1 })).toBe('0 to 1');
  expect(rangeText({ least: 0, leastExcluded: true })).toBe('more than 0');
  expect(rangeText({ least: 0, most: 90, mostExcluded: true })).toBe('0 or more, less than 90');
  expect(rangeText({})).toBe('');
});

test('values as text', () => {
  expect(valueText(true)).toBe('yes');
  expect(valueText([1, 0, 0])).toBe('1, 0, 0');
  expect(valueText(Infinity)).toBe('unlimited');
  expect(valueText({ mean: 0.4, distribution: 'normal' })).toBe('0.4, normal');
});
