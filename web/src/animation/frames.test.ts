import { describe, expect, it } from 'vitest';
import { frameCount, rates, timesOf, usualSeconds } from './frames';

describe('frames', () => {
  it('are evenly spread from the release to the last stop', () => {
    expect(timesOf({ seconds: 2, rate: 2 }, 8)).toEqual([0, 2, 4, 6, 8]);
    const times = timesOf({ seconds: 7, rate: 25 }, 13.7);
    expect([times.length, times[0], times.at(-1)]).toEqual([176, 0, 13.7]);
  });
  it('are at least two', () => expect(frameCount({ seconds: 0.01, rate: 10 })).toBe(2));
  it('have delays of whole hundredths of a second', () => rates.forEach((rate) => expect(100 % rate).toBe(0)));
  it('take real time, within limits', () => expect([1, 7.6, 300].map(usualSeconds)).toEqual([4, 8, 20]));
});
