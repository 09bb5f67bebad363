import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { isOverdue, patiently } from './patience';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('an answer is overdue after a while, until it comes', async () => {
  let come: (value: string) => void = () => undefined;
  const answer = patiently(new Promise<string>((done) => (come = done)));
  await vi.advanceTimersByTimeAsync(10_000);
  expect(isOverdue.value).toBe(false);
  await vi.advanceTimersByTimeAsync(15_000);
  expect(isOverdue.value).toBe(true);
  come('here');
  expect(await answer).toBe('here');
  expect(isOverdue.value).toBe(false);
});

test('one that fails at once is not', async () => {
  await expect(patiently(Promise.reject(new Error('gone')))).rejects.toThrow('gone');
  await vi.advanceTimersByTimeAsync(60_000);
  expect(isOverdue.value).toBe(false);
});
