import { afterEach, expect, test, vi } from 'vitest';
import { keptKey } from './about';
import { keepLocally, localDraftsOf } from './localDrafts';

const kept = new Map<string, string>();
vi.stubGlobal('localStorage', {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => void kept.set(key, value),
  removeItem: (key: string) => void kept.delete(key),
});
afterEach(() => kept.clear());

const draft = (revision: string) => ({ text: revision, saved: null, revision, after: null, time: 1 });

test('a tab keeps one draft, beside those of others', () => {
  for (const revision of ['a.1', 'b.1', 'a.2']) keepLocally('slope.toml', draft(revision));
  expect(localDraftsOf('slope.toml').map(({ revision }) => revision)).toEqual(['b.1', 'a.2']);
});

test('the one draft that an earlier page kept is still found', () => {
  kept.set(keptKey('draft', 'slope.toml'), JSON.stringify({ text: 'old', saved: 'hash' }));
  expect(localDraftsOf('slope.toml')).toMatchObject([{ text: 'old', saved: 'hash', after: null }]);
  keepLocally('slope.toml', draft('a.1'));
  expect(localDraftsOf('slope.toml').map(({ text }) => text)).toEqual(['old', 'a.1']);
});
