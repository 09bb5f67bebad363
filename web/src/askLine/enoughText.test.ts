import { expect, test } from 'vitest';
import { enoughText } from './enoughText';

const of = (text: string, stored: number) => enoughText({ enough: { rocks: 12_209, text }, run: { stored, rocks: 15_000 } });

test('an answer of a part of the rocks says how all are stored', () => {
  expect(of('12,209 rocks would do (now 3,343)', 3343)).toBe(
    '12,209 rocks would do (now 3,343). Only 3,343 of 15,000 rocks have stored trajectories; trajectories = "all" of [output] stores all',
  );
  expect(of('20,000 rocks would do (now 15,000)', 15_000)).toBe('20,000 rocks would do (now 15,000)');
  expect(of('', 3343)).toBe('');
});
