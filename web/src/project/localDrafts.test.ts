import { afterEach, expect, test } from 'vitest';
import { storageKey } from '../state/about';
import { localDraftsOf, storeLocal } from './localDrafts';

afterEach(() => localStorage.clear());

const draft = (revision: string) => ({ text: revision, saved: null, revision, after: null, time: 1 });

test('each tab has one draft', () => {
  for (const revision of ['a.1', 'b.1', 'a.2']) storeLocal('slope.toml', draft(revision));
  expect(localDraftsOf('slope.toml').map(({ revision }) => revision)).toEqual(['b.1', 'a.2']);
});

test('a draft in the earlier format is still found', () => {
  localStorage.setItem(storageKey('draft', 'slope.toml'), JSON.stringify({ text: 'old', saved: 'hash' }));
  expect(localDraftsOf('slope.toml')).toMatchObject([{ text: 'old', saved: 'hash', after: null }]);
  storeLocal('slope.toml', draft('a.1'));
  expect(localDraftsOf('slope.toml').map(({ text }) => text)).toEqual(['old', 'a.1']);
});
