import { expect, test } from 'vitest';
import type { AskedAnswer, Interval, LineAnswer } from '../api/line';
import type { Summary } from '../api/results';
import type { Figures, Variation, WhatIfAnswer } from '../api/whatIf';
import { placeLabel, placeName } from '../askLine/shape';
import { inputsOf, modelsOf, rangeOver } from '../askLine/spread';
import { cardsOf } from './cards';
import { doubtsOf } from './doubts';
import { firstOf } from './firstOf';
import { shouldBegin, type Situation } from './jobStep';
import { middleEnd, middleEnds, spreadOf } from './middleEnd';
import { placeOf } from './whichPlace';

const figures = (share: number, height: number | null): Figures => {
  const interval = (value: number, by: number): Interval => [value, value - by, value + by];
  const energy = height === null ? null : interval(1e5 * height, 1e4);
  return {
    rocks: Math.round(1000 * share),
    share: interval(share, 0.01),
    energy_J: energy,
    ke_translational_J: energy,
    ke_total_J: energy,
    height_m: height === null ? null : interval(height, 0.2),
    velocity_m_s: null,
    needs: height === null ? null : { energy_J: 1.5e5 * height, class: Math.round(height), height_m: 1.2 * height + 0.5 },
    needs_at_upper_end: height === null ? null : { energy_J: 2e5 * height, class: Math.round(height) + 1, height_m: 1.2 * height + 0.7 },
  };
};
const nothing = { gained: 0, lost: 0, share: null, energy_J: null, ke_translational_J: null, ke_total_J: null, height_m: null, velocity_m_s: null };
const set = (factor: string, step_percent: number | null, of: Figures, model?: string): Variation => ({
  ...of,
  factor,
  title: factor,
  step_percent,
  ...(model !== undefined && { model, shapes: model === 'rigid_body' ? ['equant', 'my_slab'] : [] }),
  text: '',
  clipped: '',
  changes: [],
  difference: nothing,
});
const whatIf = (variations: Variation[]): WhatIfAnswer => ({
  rocks: 1000,
  planned: 1000,
  percentile: 95,
  confidence: 0.95,
  energy: 'translational',
  standard: 'UNI 11211-4',
  model: 'lumped_mass',
  base: figures(0.1, 0.7),
  models_disagree: [
    { model: 'rigid_sphere', figure: 'height_m' },
    { model: 'rigid_body', figure: 'share' },
  ],
  variations,
});
const varied = whatIf([
  set('model', null, figures(0.12, 4.7), 'rigid_sphere'),
  set('model', null, figures(0, null), 'rigid_body'),
  set('roughness', -25, figures(0, null)),
  set('roughness', 25, figures(0.179, 0.9)),
]);

const line = (height: number, block: number | null = 0.5): LineAnswer =>
  ({
    kind: 'line',
    run: { rocks: 1000, stored: 1000 },
    standard: 'UNI 11211-4',
    applied_factors: [{ symbol: 'γ_R', value: 1.3 }, { symbol: 'γ_QF', value: 1 }],
    sections: [],
    factors: { of_total_energy: false, level: 'MEL', block_mass_kg: null },
    design_percentile: 95,
    confidence: 0.95,
    whole: {
      rocks: 100,
      share: { value: 0.1, low: 0.08, high: 0.12 },
      percentiles: { height_m: { 95: [height, height - 0.1, null] }, ke_translational_J: { 95: [7e4, 6e4, 8e4] }, ke_total_J: { 95: [9e4, 8e4, 1e5] } },
      needs: { energy_J: 9e4, class: 1, height_m: 1.2 },
      needs_at_upper_end: null,
      largest_block_m: block,
    },
    problems: [],
  }) as unknown as LineAnswer;

test('a range is over the own values and those of the sets, and knows which give its ends', () => {
  const over = rangeOver(varied.base, inputsOf(varied), 'share')!;
  expect([over.low, over.high, over.atLow?.step_percent, over.atHigh?.step_percent]).toEqual([0, 0.179, -25, 25]); // of no rock the share is 0
  expect(rangeOver(varied.base, inputsOf(varied), 'height_m')).toMatchObject({ low: 0.7, high: 0.9, atLow: null });
  expect(rangeOver(varied.base, modelsOf(varied), 'height_m')).toMatchObject({ low: 0.7, high: 4.7 });
  // The figure that it stands beside is in it, also if the sets have fewer rocks.
  expect(rangeOver(varied.base, modelsOf(varied), 'height_m', [0.6, 0.5, 0.8])!.low).toBe(0.6);
  expect(rangeOver(varied.base, [], 'share')).toBeNull();
});

test('a range reaches to the outermost ends of the intervals of its sets', () => {
  const over = (by: 'height_m' | 'share' | 'needs_class' | 'needs_energy_J', shown: Interval | null = null) => rangeOver(varied.base, modelsOf(varied), by, shown)!.chance;
  expect(over('height_m')).toEqual({ low: 0.7 - 0.2, high: 4.7 + 0.2 });
  expect(over('height_m', [0.65, 0.3, 1])).toEqual({ low: 0.3, high: 4.7 + 0.2 }); // that of all rocks
  expect(over('height_m', [0.65, null, null])).toEqual({ low: null, high: 4.7 + 0.2 }); // the least one has none
  expect(over('share')).toEqual({ low: 0 - 0.01, high: 0.12 + 0.01 });
  // What a fence needs is known at the upper ends only.
  expect(over('needs_class')).toEqual({ low: null, high: 6 });
  expect(over('needs_energy_J')).toEqual({ low: null, high: 9.4e5 });
});

test('so do they for an area', () => {
  const area = { kind: 'polygon', run: { rocks: 1000, stored: 1000 }, entering: { rocks: 100, share: { value: 0.1, low: 0.08, high: 0.12 } }, percentiles: { ke_total_J: { 95: [9e4, 8e4, 1e5] } }, problems: [], ensembles: { ensembles: 10, crossing: 8, confidence: 0.9, share: [0.1, 0.02, 0.3], stopping: [0, 0, 0], height_m: null, ke_translational_J: null, ke_total_J: [9e4, 4e4, 2e5], velocity_m_s: null } } as unknown as AskedAnswer;
  const [share, energy] = cardsOf(area, varied, 'the asked area');
  expect(share).toMatchObject({ title: 'Enters the asked area', figures: [{ inputs: { text: '2 to 30 %', withChance: '' } }] });
  expect(energy!.figures[1]).toMatchObject({ inputs: { text: '40 to 200 kJ', why: expect.stringContaining('8 ensembles with rocks that enter, of 10') } });
});

test('four cards, each with sampling, inputs and models', () => {
  const [share, energy, height, fence] = cardsOf(line(0.7), varied, 'Road');
  expect(share).toMatchObject({ title: 'Passes Road', figures: [{ value: '10 %', sampling: '8 to 12 %', inputs: { text: '0 to 17.9 %' }, models: { text: '0 to 12 %' } }] });
  expect(share!.notes).toEqual(['100 of 1,000 rocks.', 'By models: lumped mass 10 % (this run), rigid sphere 12 %, rigid body (equant, my slab) 0 %.']);
  expect(energy!.figures.map(({ name, value, inputs }) => [name, value, inputs?.text, inputs?.withChance])).toEqual([
    ['translational', '70 kJ', '70 to 90 kJ', '60 to 100 kJ'],
    ['total', '90 kJ', '70 to 90 kJ', '60 to 100 kJ'],
  ]);
  expect(height!.figures[0]).toMatchObject({ value: '0.7 m', sampling: '0.6 m or more', models: { text: '0.7 to 4.7 m', withChance: '0.5 to 4.9 m' } });
  expect(fence).toMatchObject({ title: 'Fence needed', notes: [] });
  expect(fence!.printed).toEqual(['Class by models: lumped mass 1 (this run), rigid sphere 5, rigid body (equant, my slab) none crosses.', 'By UNI 11211-4 at MEL, with γ_R 1.3; translational energies as simulated, without a design block.']);
  expect(energy!.printed).toEqual(['Translational by models: lumped mass 70 kJ (this run), rigid sphere 470 kJ, rigid body (equant, my slab) none crosses.']);
  // Over what the sets need by the check, not over their percentiles.
  expect(fence!.figures).toMatchObject([
    { name: 'class', value: '1', sampling: 'too few rocks', inputs: { text: '1 in each', withChance: 'too few rocks' }, models: { text: '1 to 5', withChance: 'up to 6' } },
    { value: '90 kJ', inputs: { text: '90 to 135 kJ' }, models: { text: '90 to 705 kJ', withChance: 'up to 940 kJ' } },
    { value: '1.2 m', inputs: { text: '1.2 to 1.58 m' }, models: { text: '1.2 to 6.14 m', why: 'lumped mass 1.2 m (this run), rigid sphere 6.14 m, rigid body (equant, my slab) none crosses' } },
  ]);
  const [, , , bare] = cardsOf({ ...line(0.7), standard: null }, null, 'Road');
  expect(bare).toMatchObject({ title: 'Fence needed', printed: ['No standard is chosen: no factors are applied.'], figures: [{ name: 'energy', inputs: null, models: null }, {}] });
});

test('a fence of a long line has what its stretches need', () => {
  const stretch = (from_m: number, rocks: number, needs: LineAnswer['whole']['needs']) => ({ from_m, to_m: from_m + 20, rocks, needs, needs_at_upper_end: null });
  const of = { ...line(0.7), sections: [stretch(0, 2, null), stretch(20, 18, { energy_J: 1.2e6, class: 4, height_m: 3.41 }), stretch(40, 9, { energy_J: 9e5, class: 3, height_m: 5.73 })] } as unknown as LineAnswer;
  const [, energy, , fence] = cardsOf(of, null, 'Road');
  expect(fence).toMatchObject({ title: 'Fence needed, whole line', notes: ['By stretches, red: most energy from 20 to 40 m (18 rocks), most height from 40 to 60 m (9 rocks) along the line. A fence that is the same all along needs the most of them.'] });
  expect(fence!.figures.map(({ stretches }) => stretches)).toEqual(['up to 4', 'up to 1,200 kJ', 'up to 5.73 m']);
  expect(energy!.figures[0]!.stretches).toBe('');
  const block = { ...of, factors: { of_total_energy: false, level: 'SEL', block_mass_kg: 3879 }, sections: of.sections.slice(0, 2) } as LineAnswer;
  const bySel = cardsOf(block, null, 'Road')[3]!;
  expect(bySel.notes).toEqual(['By stretches, red: most energy and height from 20 to 40 m (18 rocks) along the line. A fence that is the same all along needs the most of them.']);
  expect(bySel.printed).toEqual(['By UNI 11211-4 at SEL, with γ_R 1.3; velocities with a design block of 3,879 kg.']);
});

test('ensembles of the run take the place of steps of its inputs', () => {
  const ensembles = { ensembles: 50, crossing: 40, confidence: 0.9, share: [0.1, 0.02, 0.3], height_m: [0.7, 0.5, 1.4], ke_translational_J: null, ke_total_J: [9e4, 4e4, 2e5], velocity_m_s: null, needs_energy_J: [9e4, 5e4, 3e5], needs_class: [1, 0, 3], needs_height_m: [1.2, 1.1, 2] };
  const [share, energy, height, fence] = cardsOf({ ...line(0.7), ensembles } as unknown as LineAnswer, varied, 'Road');
  expect(share!.figures[0]).toMatchObject({ inputs: { text: '2 to 30 %', why: expect.stringMatching(/^90 % of the run's 50 ensembles, /) }, models: { text: '0 to 12 %' } });
  expect(energy!.figures.map(({ inputs }) => inputs?.text)).toEqual(['too few ensembles', '40 to 200 kJ']);
  expect(height!.figures[0]!.inputs!.why).toMatch(/^90 % of the run's 40 ensembles with rocks that cross, of 50/);
  expect(fence!.figures.map(({ inputs }) => inputs?.text)).toEqual(['0 to 3', '50 to 300 kJ', '1.1 to 2 m']);
});

const known = { answer: null, whatIf: null, summary: null, isOutdated: false, hasRemark: false };
test('doubts, the most serious first', () => {
  const summary = { notes: ['120 of 1,000 rocks left the model: runout is cut'], warnings: ['a.toml:3: warning: no seed'], end_reasons: {} } as unknown as Summary;
  const ground = { kind: 'mostly_on_ground', where: 'rocks', what: '80 % of the way was on the ground', why: 'blocks bounce', hint: 'Look at roughness_deg', text: '' };
  const answer = { ...line(0.4), problems: [ground] } as unknown as LineAnswer;
  const found = doubtsOf({ answer, whatIf: varied, summary, isOutdated: true, hasRemark: false });
  expect(found.map(({ kind }) => kind)).toEqual(['outdated', 'models', 'height', 'ground', 'left', 'run']);
  expect(found[1]!.text).toBe('Rock models disagree by more than chance: the 95 % height is 0.4 m with lumped mass (this run) and 4.7 m with rigid sphere; the share that passes is 10 % with lumped mass (this run) and 0 % with rigid body.');
  expect(found[1]!.advice).toContain('give the reason as text of the title block');
  expect(doubtsOf({ ...known, whatIf: varied, hasRemark: true })[0]).toMatchObject({ kind: 'models', advice: '' });
  expect(found[2]!.text).toContain('less than the diameter of the largest block that crosses, 0.5 m');
  expect(found[5]!.text).toBe('No seed');
});
test('models that agree by the engine give no doubt, and a warning of the run about them is of that kind', () => {
  const summary = { warnings: ['warning: [analysis]: model = "rigid_sphere" gives another runout'], warning_kinds: [{ warning: 0, kind: 'models_disagree', where: '[analysis]' }], end_reasons: {} } as unknown as Summary;
  const found = doubtsOf({ ...known, whatIf: { ...varied, models_disagree: [] }, summary });
  expect(found.map(({ kind, text }) => [kind, text])).toEqual([['models', '[analysis]: model = "rigid_sphere" gives another runout']]);
});
test('a warning of the run is left out where the answer has one of the same kind about the same thing', () => {
  const summary = {
    warnings: ['warning: rocks: they slid', 'warning: line "Road": too low', 'warning: line "Path": too low', 'warning: no seed'],
    warning_kinds: [
      { warning: '0', kind: 'mostly_on_ground', where: 'rocks' },
      { warning: '1', kind: 'height_below_block', where: 'line "Road"' },
      { warning: '2', kind: 'height_below_block', where: 'line "Path"' },
    ],
  } as unknown as Summary;
  const ofKind = (kind: string, where: string, what: string) => ({ kind, where, what, why: '', hint: '', text: '' });
  const answer = { ...line(0.7), problems: [ofKind('height_below_block', 'line "Road"', 'the road'), ofKind('', 'line', 'parts off the terrain')] } as unknown as LineAnswer;
  const texts = (of: LineAnswer | null) => doubtsOf({ ...known, answer: of, summary }).map(({ kind, text }) => `${kind}: ${text}`);
  expect(texts(answer)).toEqual(['height: The road.', 'ground: Rocks: they slid', 'place: Parts off the terrain.', 'run: Line "Path": too low', 'run: No seed']);
  expect(texts({ ...answer, problems: [ofKind('mostly_on_ground', 'rocks', 'slid')] } as unknown as LineAnswer)[0]).toBe('ground: Slid.');
  expect(texts(null)).toHaveLength(4);
});
test('no doubt where models agree, heights are above the block and nothing was warned of', () => {
  expect(doubtsOf({ ...known, answer: line(0.7), whatIf: { ...whatIf([set('model', null, figures(0.11, 0.8), 'rigid_sphere')]), models_disagree: [] } })).toEqual([]);
  expect(doubtsOf({ ...known, answer: line(0.01, 0) })[0]!.text).toContain('next to nothing');
});

test('the job begins once for each run and place', () => {
  const now: Situation = { isOn: true, question: 'a', isComputing: false, isKnown: true, last: null, begun: null };
  expect(shouldBegin(now)).toBe(true);
  expect(shouldBegin({ ...now, begun: 'b' })).toBe(true); // the line was moved, or the run is another one
  for (const change of [{ isOn: false }, { question: null }, { isComputing: true }, { isKnown: false }, { last: 'a' }, { begun: 'a' }])
    expect(shouldBegin({ ...now, ...change })).toBe(false);
});

test('the place: what is asked, or the road, another collector, a barrier', () => {
  const net = { name: 'Net', kind: 'barrier' } as const;
  const [foot, road] = [{ name: 'Foot', kind: 'collector' }, { name: 'Road K12', kind: 'collector' }] as const;
  const drawn = { kind: 'line', points: [[1, 2], [3, 4]] } as const;
  expect(placeOf({ kind: 'line', points: [[1, 2], [3, 4]] }, 3, [road])).toEqual(drawn);
  expect(placeOf({ kind: 'line', points: [[1, 2]] }, 3, [net, foot, road])).toEqual({ kind: 'barrier', name: 'Road K12' });
  expect(placeOf(null, 3, [net, foot])).toEqual({ kind: 'barrier', name: 'Foot' });
  expect(placeOf(null, 3, [net])).toEqual({ kind: 'barrier', name: 'Net' });
  expect(placeOf(null, 3, [])).toBeNull();
  expect(placeName({ kind: 'line', points: [[15.204, 0]] }, 2)).toBe('x = 15.2 m');
  expect(placeLabel({ kind: 'line', points: [[0, 0], [1, 0]] }, 3)).toBe('Asked line'); // prettier-ignore
  expect(placeLabel({ kind: 'barrier', name: 'the asked road' }, 3)).toBe('the asked road');
});

test('half of the rocks end below the middle end', () => {
  const paths = { starts: Uint32Array.of(0, 2, 4, 6), positions: Float32Array.of(0, 0, 9, 1, 0, 3, 0, 0, 9, 2, 0, 1, 0, 0, 9, 3, 0, 2), header: { origin: [10, 0, 100] } };
  expect(middleEnd(paths as never)).toEqual([13, 0, 102]);
  expect(middleEnd({ ...paths, starts: Uint32Array.of(0) } as never)).toBeNull();
});

test('ends about the middle one begin with it and are spread over a fifth of all', () => {
  const count = 100;
  const paths = {
    starts: Uint32Array.from({ length: count + 1 }, (_, k) => k),
    positions: Float32Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? Math.floor(k / 3) : 0)),
    header: { origin: [0, 0, 0] },
  };
  const heights = middleEnds(paths as never).map(([, , z]) => z);
  expect(heights[0]).toBe(50);
  expect([Math.min(...heights), Math.max(...heights)]).toEqual([40, 60]);
  expect(middleEnds({ ...paths, starts: Uint32Array.of(0) } as never)).toEqual([]);
  expect(spreadOf([[0, 0, 9], [3, 4, 0], [3, 5, 0]])).toBe(5);
  expect(spreadOf([])).toBe(0);
});

test('long lists say how much is left out', () => {
  expect(firstOf(['a', 'b'], 2, 'there')).toEqual(['a', 'b']);
  expect(firstOf(['a', 'b', 'c'], 2, 'there')).toEqual(['a', 'and 2 more, there']);
});
