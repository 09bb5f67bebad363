import { expect, test } from 'vitest';
import { allWritten, writeInTurn } from './writes';

test('each write starts when the previous one has ended, with or without success', async () => {
  const events: string[] = [];
  const request = (name: string, fails = false) =>
    writeInTurn(async () => {
      events.push(`${name} begins`);
      await Promise.resolve();
      events.push(`${name} ends`);
      if (fails) throw new Error(name);
      return name;
    });
  const [first, second, third] = [request('first'), request('second', true), request('third')];
  await expect(second).rejects.toThrow('second');
  await allWritten();
  expect(events).toEqual(['first begins', 'first ends', 'second begins', 'second ends', 'third begins', 'third ends']);
  expect([await first, await third]).toEqual(['first', 'third']);
});
