import { beforeEach, expect, test } from 'vitest';
import { attempt, messages, notify, resolveAll } from './messages';

const texts = () => messages.value.map(({ text }) => text);
const fail = (text: string) => () => Promise.reject(new Error(text));

beforeEach(() => (messages.value = []));

test('success removes the error of the same action only', async () => {
  await attempt('save the project', fail('the disk is full'));
  await attempt('compute', fail('no rocks'));
  expect(texts()).toEqual(['the disk is full', 'no rocks']);
  await attempt('save the project', () => Promise.resolve());
  expect(texts()).toEqual(['no rocks']);
});

test('a new failure replaces the previous one of the same action', async () => {
  await attempt('save the project', fail('the disk is full'));
  await attempt('save the project', fail('the folder is gone'));
  expect(texts()).toEqual(['the folder is gone']);
});

test('closing a project removes its errors, but not other messages', () => {
  notify('error', 'Could not change the name');
  notify('saved', 'Saved a.toml');
  resolveAll();
  expect(texts()).toEqual(['Saved a.toml']);
});

test('an aborted request is not a failure', async () => {
  await attempt('draw', () => Promise.reject(new DOMException('', 'AbortError')));
  expect(texts()).toEqual([]);
});
