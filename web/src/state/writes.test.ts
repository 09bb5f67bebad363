import { expect, test } from 'vitest';
import { allWritten, writeInTurn } from './writes';

test('one begins when the one before has ended, well or not', async () => {
  const told: string[] = [];
  const request = (name: string, fails = false) =>
    writeInTurn(async () => {
      told.push(`${name} begins`);
      await Promise.resolve();
      told.push(`${name} ends`);
      if (fails) throw new Error(name);
      return name;
    });
  const [first, second, third] = [request('first'), request('second', true), request('third')];
  await expect(second).rejects.toThrow('second');
  await allWritten();
  expect(told).toEqual(['first begins', 'first ends', 'second begins', 'second ends', 'third begins', 'third ends']);
  expect([await first, await third]).toEqual(['first', 'third']);
});
