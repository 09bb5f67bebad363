import { expect, test } from 'vitest';
import { choiceOf, type LocalDraft } from './revisions';

const local = (text: string, revision: string, after: string | null, time = 0): LocalDraft => ({
  text,
  saved: 'hash',
  revision,
  after,
  time,
});
const kept = (text: string, ...revisions: string[]) => ({ text, saved: 'hash', revisions });
const texts = (drafts: readonly { text: string }[]) => drafts.map(({ text }) => text);

/// The texts of the chosen draft, of those to ask about, and of superseded ones.
function choice(...given: Parameters<typeof choiceOf>) {
  const { chosen, aside, superseded } = choiceOf(...given);
  return [chosen?.text ?? null, texts(aside), texts(superseded)];
}

test('the server draft supersedes the drafts it is based on', () => {
  expect(choice('file', kept('tuesday', 'a.5', 'b.2'), [local('monday', 'a.5', 'a.4', 9)])).toEqual([
    'tuesday',
    [],
    ['monday'],
  ]);
  expect(choice('file', kept('later', 'a.7'), [local('sooner', 'a.6', 'a.5', 9)])).toEqual(['later', [], ['sooner']]);
});

test('a draft based on the server draft is newer', () => {
  expect(choice('file', kept('one', 'a.5'), [local('two', 'a.6', 'a.5')])).toEqual(['two', [], []]);
  expect(choice('file', kept('one', 'b.1', 'a.5'), [local('two', 'a.7', 'a.3')])).toEqual(['two', [], []]);
});

test('the user decides between two unrelated drafts', () => {
  expect(choice('file', kept('theirs', 'a.5', 'b.2'), [local('mine', 'a.6', 'a.5', 9)])).toEqual([
    'theirs',
    ['mine'],
    [],
  ]);
});

test('without a server draft the newest is chosen', () => {
  expect(choice('file', null, [local('old', 'a.1', null, 1), local('new', 'b.1', null, 2)])).toEqual([
    'new',
    ['old'],
    [],
  ]);
  expect(choice('file', null, [])).toEqual([null, [], []]);
});

test('a draft equal to the file or to the other draft is superseded', () => {
  expect(choice('file', null, [local('file', 'a.1', null)])).toEqual([null, [], ['file']]);
  expect(choice('file', kept('one', 'b.1'), [local('one', 'a.1', null)])).toEqual(['one', [], ['one']]);
});
