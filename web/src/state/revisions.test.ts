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

/// What is taken, what is asked for, what is let go.
function chosen(...asked: Parameters<typeof choiceOf>) {
  const { taken, aside, outdone } = choiceOf(...asked);
  return [taken?.text ?? null, texts(aside), texts(outdone)];
}

test('what the server has is newer than what it comes from', () => {
  expect(chosen('file', kept('tuesday', 'a.5', 'b.2'), [local('monday', 'a.5', 'a.4', 9)])).toEqual([
    'tuesday',
    [],
    ['monday'],
  ]);
  expect(chosen('file', kept('later', 'a.7'), [local('sooner', 'a.6', 'a.5', 9)])).toEqual(['later', [], ['sooner']]);
});

test('what was made of what the server has is newer', () => {
  expect(chosen('file', kept('one', 'a.5'), [local('two', 'a.6', 'a.5')])).toEqual(['two', [], []]);
  expect(chosen('file', kept('one', 'b.1', 'a.5'), [local('two', 'a.7', 'a.3')])).toEqual(['two', [], []]);
});

test('of two that do not know of each other the user says', () => {
  expect(chosen('file', kept('theirs', 'a.5', 'b.2'), [local('mine', 'a.6', 'a.5', 9)])).toEqual([
    'theirs',
    ['mine'],
    [],
  ]);
});

test('without a draft of the server the newest is taken', () => {
  expect(chosen('file', null, [local('old', 'a.1', null, 1), local('new', 'b.1', null, 2)])).toEqual([
    'new',
    ['old'],
    [],
  ]);
  expect(chosen('file', null, [])).toEqual([null, [], []]);
});

test('one that says what the file says, or the other, is none', () => {
  expect(chosen('file', null, [local('file', 'a.1', null)])).toEqual([null, [], ['file']]);
  expect(chosen('file', kept('one', 'b.1'), [local('one', 'a.1', null)])).toEqual(['one', [], ['one']]);
});
