import { expect, test } from 'vitest';
import type { FolderFile, Run } from '../api/types';
import { copyName, isFound, listProjects } from './projectList';

const saved = (name: string, modified: string, kind: FolderFile['kind'] = 'project'): FolderFile => ({ name, modified, kind, bytes: 1, picture: null });
const run = (file: string, begun: string, project = 'Slope') => ({ id: begun, file, begun, project }) as Run;

const folder = [saved('a.toml', '2026-11-20T10:00:00Z'), saved('b.toml', '2026-11-21T10:00:00Z'), saved('dem.tif', '2026-11-24T10:00:00Z', 'raster')];

test('the projects last used come first, and drafts before all', () => {
  const list = (runs: Run[], drafted: string[] = []) => listProjects(folder, drafted, runs).map(({ file }) => file);
  expect(list([])).toEqual(['b.toml', 'a.toml']);
  expect(list([run('a.toml', '2026-11-22T10:00:00Z')])).toEqual(['a.toml', 'b.toml']);
  expect(list([run('a.toml', '2026-11-20T11:00:00Z')])).toEqual(['b.toml', 'a.toml']);
  expect(list([], ['new.toml', 'a.toml'])).toEqual(['new.toml', 'b.toml', 'a.toml']);
});

test('a project has its last run and the number of all', () => {
  const [a] = listProjects(folder, ['a.toml'], [run('a.toml', '2026-11-23T10:00:00Z'), run('b.toml', '2026-11-22T10:00:00Z'), run('a.toml', '2026-11-19T10:00:00Z')]);
  expect([a!.file, a!.last?.begun, a!.runs, a!.hasDraft]).toEqual(['a.toml', '2026-11-23T10:00:00Z', 2, true]);
});

test('all words of a search must be in the names', () => {
  const [project] = listProjects([saved('valley/East Face.toml', '')], [], [run('valley/East Face.toml', '2026', 'Road B12')]);
  expect(['', 'east', 'FACE b12', 'valley/'].every((search) => isFound(project!, search))).toBe(true);
  expect(['west', 'east west'].some((search) => isFound(project!, search))).toBe(false);
});

test('a copy has a free name in the same folder', () => {
  expect(copyName('x/slope.toml', ['x/slope.toml', 'slope copy.toml'])).toBe('slope copy.toml');
  expect(copyName('slope.toml', ['slope copy.toml', 'slope copy 2.toml'])).toBe('slope copy 3.toml');
});
