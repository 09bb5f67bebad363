import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { isOverdue, noticingDelay } from './patience';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test('a response is overdue after a while, until it arrives', async () => {
  let arrive: (value: string) => void = () => undefined;
  const answer = noticingDelay(new Promise<string>((done) => (arrive = done)));
  await vi.advanceTimersByTimeAsync(10_000);
  expect(isOverdue.value).toBe(false);
  await vi.advanceTimersByTimeAsync(15_000);
  expect(isOverdue.value).toBe(true);
  arrive('here');
  expect(await answer).toBe('here');
  expect(isOverdue.value).toBe(false);
});

test('a request that fails at once is not overdue', async () => {
  await expect(noticingDelay(Promise.reject(new Error('gone')))).rejects.toThrow('gone');
  await vi.advanceTimersByTimeAsync(60_000);
  expect(isOverdue.value).toBe(false);
});
