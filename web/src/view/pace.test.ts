import { expect, test } from 'vitest';
import { Pace } from './pace';

test('fast graphics draw all detail while the view moves', () => {
  const pace = new Pace();
  pace.restTook(20);
  pace.movingTook(20);
  expect(pace.moving).toBeNull();
});

test('slow graphics draw less detail, and less again until frames are fast enough', () => {
  const pace = new Pace();
  pace.restTook(2000);
  const first = pace.moving!;
  pace.movingTook(300);
  const second = pace.moving!;
  expect(second.segments).toBeLessThan(first.segments);
  for (let k = 0; k < 20; ++k) pace.movingTook(300);
  expect(pace.moving!.segments).toBeGreaterThan(0);
  // Neither fast nor slow: it stays.
  const last = pace.moving;
  for (let k = 0; k < 20; ++k) pace.movingTook(60);
  expect(pace.moving).toBe(last);
  // Fast for several frames: more detail.
  for (let k = 0; k < 6; ++k) pace.movingTook(10);
  expect(pace.moving!.segments).toBeGreaterThan(last!.segments);
});

test('all detail returns when there is less to draw', () => {
  const pace = new Pace();
  pace.restTook(2000);
  pace.restTook(80); // as fast as it may just be: no to and fro
  expect(pace.moving).not.toBeNull();
  pace.restTook(30);
  expect(pace.moving).toBeNull();
});
