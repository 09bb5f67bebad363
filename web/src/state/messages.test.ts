import { beforeEach, expect, test } from 'vitest';
import { attempt, messages, say, settleAll } from './messages';

const texts = () => messages.value.map(({ text }) => text);
const fail = (text: string) => () => Promise.reject(new Error(text));

beforeEach(() => (messages.value = []));

test('an error goes when the same goes well, and no other', async () => {
  await attempt('save the project', fail('the disk is full'));
  await attempt('compute', fail('no rocks'));
  expect(texts()).toEqual(['the disk is full', 'no rocks']);
  await attempt('save the project', () => Promise.resolve());
  expect(texts()).toEqual(['no rocks']);
});

test('another failure of the same takes the place of the last', async () => {
  await attempt('save the project', fail('the disk is full'));
  await attempt('save the project', fail('the folder is gone'));
  expect(texts()).toEqual(['the folder is gone']);
});

test('errors of a project end with it; what was done stays said', () => {
  say('error', 'Could not change the name');
  say('saved', 'Saved a.toml');
  settleAll();
  expect(texts()).toEqual(['Saved a.toml']);
});

test('what is given up is not a failure', async () => {
  await attempt('draw', () => Promise.reject(new DOMException('', 'AbortError')));
  expect(texts()).toEqual([]);
});
