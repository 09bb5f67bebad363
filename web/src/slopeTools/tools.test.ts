import { describe, expect, it } from 'vitest';
import type { Point2 } from '../api/types';
import { edited } from '../toml/edit';
import { valuesOf } from '../toml/values';
import { slopeEdits } from './edits';
import { areasBetween, groundAt, mirrored, slopeIn, type Slope } from './slope';
import { fallsLeft, fieldsOf, shaped, stationAt, usualNumbers, type Numbers, type ToolKind } from './tools';

const flat: Slope = { vertices: [[0, 20], [10, 0], [60, 0]], materials: ['Rock', 'Soil'], deviations: [[0, 0.1], [0.2, 0.2], [0, 0]] };
const tools: Record<ToolKind, Numbers> = {
  bench: { x: 5, width: 2, backfall: 0, face: 90 },
  ditch: { x: 10, depth: 1, bottom: 3, back: 45, fore: 45 },
  berm: { x: 30, height: 2, crest: 1, up: 45, down: 45 },
  regrade: { x: 2, to: 20 },
};
const kinds = Object.keys(tools) as ToolKind[];
const message = (kind: ToolKind, numbers: Numbers, slope = flat) => {
  try {
    shaped(kind, numbers, slope, false);
  } catch (error) {
    return (error as Error).message;
  }
  return '';
};

describe('slope tools', () => {
  it('cut a bench into the slope', () => {
    const { slope, cut, fill, keeps } = shaped('bench', tools.bench, flat, false);
    expect(slope.vertices).toEqual([[0, 20], [3, 14], [3, 10], [5, 10], [10, 0], [60, 0]]);
    expect(slope.materials).toEqual(['Rock', 'Rock', 'Rock', 'Rock', 'Soil']);
    expect(slope.deviations).toEqual([[0, 0.1], [0, 0], [0, 0], [0, 0], [0.2, 0.2], [0, 0]]);
    expect(keeps).toEqual([3, 5]);
    expect(cut).toBeCloseTo(4, 9); // a triangle of 2 m by 4 m
    expect(fill).toBeCloseTo(0, 9);
  });

  it('let a bench fall back into the slope, with a face that leans', () => {
    const { line } = shaped('bench', { x: 5, width: 2, backfall: 45, face: 80 }, flat, false);
    expect(line[1]).toEqual([3, 8]);
    // The face: z = 8 + (3 - x) tan 80; the ground: z = 20 - 2 x.
    const t = Math.tan((80 * Math.PI) / 180);
    expect(line[0]![0]).toBeCloseTo((8 + 3 * t - 20) / (t - 2), 9);
  });

  it('dig a ditch at the toe', () => {
    const { slope, cut, keeps } = shaped('ditch', tools.ditch, flat, false);
    expect(slope.vertices).toEqual([[0, 20], [10, 0], [11, -1], [14, -1], [15, 0], [60, 0]]);
    expect(slope.materials).toEqual(['Rock', 'Soil', 'Soil', 'Soil', 'Soil']);
    expect(slope.deviations![1]).toEqual([0.2, 0.2]);
    expect(keeps).toEqual([10, 15]);
    expect(cut).toBeCloseTo(4, 9); // a trapezium of 5 and 3 m by 1 m
  });

  it('dig a ditch at the foot of a vertical face', () => {
    const face: Slope = { vertices: [[0, 20], [10, 20], [10, 0], [60, 0]], materials: null, deviations: null };
    const { slope } = shaped('ditch', { x: 10, depth: 1, bottom: 0, back: 90, fore: 45 }, face, false);
    expect(slope.vertices).toEqual([[0, 20], [10, 20], [10, 0], [10, -1], [11, 0], [60, 0]]);
  });

  it('raise a berm', () => {
    const { slope, cut, fill } = shaped('berm', tools.berm, flat, false);
    expect(slope.vertices).toEqual([[0, 20], [10, 0], [27.5, 0], [29.5, 2], [30.5, 2], [32.5, 0], [60, 0]]);
    expect([cut, fill]).toEqual([0, 6]); // a trapezium of 5 and 1 m by 2 m
  });

  it('regrade, keeping the materials of places', () => {
    const { slope, cut, fill } = shaped('regrade', tools.regrade, flat, false);
    // From (2, 16) to (20, 0), divided where the soil begins.
    expect(slope.vertices.map(([x]) => x)).toEqual([0, 2, 10, 20, 60]);
    expect(slope.vertices[2]![1]).toBeCloseTo(16 - (8 / 18) * 16, 6);
    expect(slope.materials).toEqual(['Rock', 'Rock', 'Soil', 'Soil']);
    expect(cut).toBe(0);
    expect(fill).toBeCloseTo(0.5 * slope.vertices[2]![1] * 18, 4);
    const steep = shaped('regrade', { x: 0, to: 12, angle: 60 }, { ...flat, vertices: [[0, 20], [10, 20], [12, 0], [60, 0]], materials: null, deviations: null }, false);
    expect(steep.slope.vertices[1]![0]).toBe(0.453); // 12 - 20/tan 60
    expect(steep.cut).toBeGreaterThan(80);
  });

  it('keep the bits of what lies outside, on both sides', () => {
    const odd: Slope = { vertices: [[0.1 + 0.2, 20.123456789], [1 / 3, 20], [10, 0], [57.000001, Math.PI], [60, 1 / 7 + 5]], materials: null, deviations: null };
    for (const [kind, numbers] of [['bench', { ...tools.bench, x: 6 }], ['ditch', tools.ditch], ['berm', tools.berm], ['regrade', tools.regrade]] as const) {
      const { slope, keeps } = shaped(kind, numbers, odd, false);
      const outside = odd.vertices.filter(([x]) => x < 1 || x > 50);
      expect(keeps[1]).toBeLessThan(50);
      for (const vertex of outside) expect(slope.vertices).toContain(vertex);
      expect(slope.vertices.every(([x], k) => k === 0 || x >= slope.vertices[k - 1]![0])).toBe(true);
    }
  });

  it('are the same on a mirrored slope', () => {
    for (const kind of kinds) {
      const right = shaped(kind, tools[kind], flat, false);
      const numbers = Object.fromEntries(Object.entries(tools[kind]).map(([key, value]) => [key, ['x', 'to'].includes(key) ? -value : value]));
      const left = shaped(kind, numbers, mirrored(flat), true);
      expect(mirrored(left.slope)).toEqual(right.slope);
      expect(left.cut).toBe(right.cut);
      expect(left.keeps.map((x) => -x)).toEqual(right.keeps);
    }
    expect([fallsLeft(flat), fallsLeft(mirrored(flat))]).toEqual([false, true]);
  });

  it('follow their handles', () => {
    const [toe, far] = shaped('ditch', tools.ditch, flat, false).handles;
    expect(toe!.moved([12, 3])).toMatchObject({ x: 12 });
    expect(far!.moved([16, -2])).toMatchObject({ depth: 2, bottom: 4 });
    const left = shaped('ditch', { ...tools.ditch, x: -10 }, mirrored(flat), true).handles;
    expect(left[1]!.at).toEqual([-14, -1]);
    expect(left[1]!.moved([-16, -2])).toMatchObject({ x: -10, depth: 2, bottom: 4 });
    for (const kind of kinds)
      for (const { at, moved } of shaped(kind, tools[kind], flat, false).handles) {
        const same = moved(at);
        for (const [key, value] of Object.entries(tools[kind])) expect(same[key]).toBeCloseTo(value, 2);
      }
  });

  it('refuse what cannot be', () => {
    expect(message('bench', { ...tools.bench, face: 95 })).toBe('Face behind it: 95° is steeper than vertical.');
    expect(message('ditch', { ...tools.ditch, depth: 0 })).toBe('Depth: 0 m; expected 0.01 to 10,000 m.');
    expect(message('ditch', { ...tools.ditch, depth: NaN })).toBe('Depth: a number is missing.');
    expect(message('ditch', { ...tools.ditch, bottom: 60 })).toBe('It does not fit: x = 71 is off the section.');
    expect(message('ditch', { ...tools.ditch, bottom: 48.5 })).toMatch(/^The side to the road does not reach the ground/);
    expect(message('ditch', { ...tools.ditch, x: 2 })).toMatch(/^The bottom would be above the ground/);
    expect(message('bench', { ...tools.bench, x: 30 })).toMatch(/^The ground does not rise behind the edge/);
    expect(message('bench', { ...tools.bench, width: 8 })).toBe('It does not fit: x = -3 is off the section.');
    expect(message('bench', { ...tools.bench, face: 50 })).toMatch(/^The face behind the bench does not reach the ground/);
    expect(message('berm', { ...tools.berm, x: 5, crest: 3 })).toMatch(/^The crest would be inside of the slope/);
    expect(message('regrade', { x: 20, to: 2 })).toBe('The first place must be uphill of the second one.');
    expect(message('regrade', { x: 9.5, to: 20, angle: 10 })).toMatch(/^A slope of 10° from the second place/);
    expect(message('ditch', { ...tools.ditch, x: 99 })).toBe('x = 99 is off the section');
  });

  it('find the place of an elevation from the top', () => {
    const steps: Slope = { vertices: [[0, 20], [10, 10], [12, 10], [20, 14], [40, 0]], materials: null, deviations: null };
    expect(stationAt(steps, 12, false)).toBe(8);
    expect(stationAt(mirrored(steps), 12, true)).toBe(-8);
    expect(() => stationAt(steps, 25, false)).toThrow('The section has no ground at z = 25 m.');
  });

  it('begin with numbers that are possible', () => {
    const slopes: Slope[] = [flat, { vertices: [[0, 0], [3.1, -12.2], [6.7, -12.2], [9.8, -24.4], [13.4, -25], [26, -22.5]], materials: null, deviations: null }];
    for (const slope of [...slopes, ...slopes.map(mirrored)])
      for (const kind of ['bench', 'ditch', 'berm', 'regrade'] as const) {
        const numbers = usualNumbers(kind, slope, fallsLeft(slope));
        expect(fieldsOf(kind, numbers).every(({ key }) => Number.isFinite(numbers[key]))).toBe(true);
        expect(() => shaped(kind, numbers, slope, fallsLeft(slope)), kind).not.toThrow();
      }
  });
});

describe('a slope', () => {
  it('has its ground at a step and between vertices', () => {
    const step: Slope = { vertices: [[0, 4], [2, 4], [2, 0], [4, 1]], materials: null, deviations: null };
    expect(groundAt(step, 2, 'high').point).toEqual([2, 4]);
    expect(groundAt(step, 2, 'low').point).toEqual([2, 0]);
    expect(groundAt(step, 3).point).toEqual([3, 0.5]);
    expect(areasBetween(step, { ...step, vertices: [[0, 4], [2, 0], [4, 1]] })).toEqual({ cut: 4, fill: 0 });
    expect(areasBetween(step, { ...step, vertices: [[0, 3], [4, 3]] })).toEqual({ cut: 2, fill: 5 });
  });

  it('is refused if its lists do not fit', () => {
    const read = (text: string) => slopeIn(valuesOf(text));
    expect(() => read('[terrain]\nsection = [[0, 0], [1, 1], [0.5, 2]]')).toThrow('folds back');
    expect(() => read('[terrain]\nsection = [[0, 0], [1, 1]]\nwidth_m = 3')).toThrow('extruded');
    expect(() => read('[terrain]\nsection = [[0, 0], [1, 1]]\n[ground]\nsegments = ["a", "b"]')).toThrow('ground.segments has 2 entries and the section needs 1');
  });

  it('is changed in the text with its comments kept', () => {
    const text = `# A cutting.
[terrain]
section = [
  # the crest
  [0, 20.50],  # surveyed
  # the toe
  [10, 0],  # at the kerb
  [60, 0],  # far away
]
section_std_dev_m = [[0, 0.1], [0, 0.2], [0, 0]]

[ground]
segments = ["Rock", "Soil"]  # by eye
`;
    const { slope, isListedLeftwards } = slopeIn(valuesOf(text));
    const { slope: next } = shaped('ditch', tools.ditch, slope, false);
    const after = edited(text, slopeEdits(valuesOf(text), next, isListedLeftwards));
    expect(after).toBe(`# A cutting.
[terrain]
section = [
  # the crest
  [0, 20.50],  # surveyed
  # the toe
  [10, 0],  # at the kerb
  [11, -1],
  [14, -1],
  [15, 0],
  [60, 0],  # far away
]
section_std_dev_m = [[0, 0.1], [0, 0.2], [0, 0], [0, 0], [0, 0], [0, 0]]

[ground]
segments = ["Rock", "Soil", "Soil", "Soil", "Soil"]  # by eye
`);
  });

  it('is changed in the order of the project', () => {
    const text = '[terrain]\nsection = [[60, 0], [10, 0], [0, 20]]\n[ground]\nsegments = ["Soil", "Rock"]\n';
    const { slope, isListedLeftwards } = slopeIn(valuesOf(text));
    expect(isListedLeftwards).toBe(true);
    const { slope: next } = shaped('bench', tools.bench, slope, false);
    const values = valuesOf(edited(text, slopeEdits(valuesOf(text), next, isListedLeftwards)));
    expect((values.terrain as { section: Point2[] }).section).toEqual([[60, 0], [10, 0], [5, 10], [3, 10], [3, 14], [0, 20]]);
    expect((values.ground as { segments: string[] }).segments).toEqual(['Soil', 'Rock', 'Rock', 'Rock', 'Rock']);
  });

  it('loses rows from the text', () => {
    const text = '[terrain]\nsection = [[0, 20], [5, 12], [8, 11], [10, 0], [60, 0]]\n';
    const { slope } = slopeIn(valuesOf(text));
    const { slope: next } = shaped('regrade', { x: 0, to: 10 }, slope, false);
    expect(edited(text, slopeEdits(valuesOf(text), next, false))).toBe('[terrain]\nsection = [[0, 20], [10, 0], [60, 0]]\n');
  });
});
