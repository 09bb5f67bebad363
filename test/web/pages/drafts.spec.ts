// Nothing that was typed is lost: not by a reload, not by a server that dies.

import { openExample, openForm } from '../support/steps';
import { expect, test } from '../support/workbench';

const roughness = 'Roughness: mean';

test('a reload in the middle of an edit keeps it', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  const saved = server.read('tutorial-1/tutorial-1-2d.toml');
  await openForm(page, /^Type Two/);
  await page.getByLabel(roughness).fill('2.5');
  await page.getByLabel(roughness).press('Tab');
  await page.reload();
  await openForm(page, /^Type Two/);
  await expect(page.getByLabel(roughness)).toHaveValue('2.5');
  expect(server.read('tutorial-1/tutorial-1-2d.toml')).toBe(saved);
  // The file as it was is one step back.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByLabel(roughness)).toHaveValue('');
});

test('comments and order of the file survive where nothing was touched', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  const before = server.read('tutorial-1/tutorial-1-2d.toml');
  await openForm(page, /^Type Two/);
  await page.getByLabel('Normal restitution: mean').fill('0.41');
  await page.getByLabel('Normal restitution: mean').press('Tab');
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await expect(page.getByText(/^Saved/)).toBeVisible();
  const after = server.read('tutorial-1/tutorial-1-2d.toml');
  expect(after).toContain('mean = 0.41');
  expect(after.replace('mean = 0.41', 'mean = 0.4')).toBe(before);
});

test('a server that is killed and started again finds the page, the draft and the run', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type Two/);
  await page.getByLabel(roughness).fill('1.5');
  await page.getByLabel(roughness).press('Tab');
  await page.waitForResponse((response) => response.url().endsWith('/api/draft'));
  await server.end('SIGKILL');
  await expect(page.getByRole('alert').filter({ hasText: 'The server does not answer' })).toBeVisible({ timeout: 30_000 });
  await page.getByLabel(roughness).fill('1.75');
  await page.getByLabel(roughness).press('Tab');
  await server.start();
  await expect(page.getByRole('alert').filter({ hasText: 'The server does not answer' })).toBeHidden({ timeout: 30_000 });
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await expect(page.getByText(/^Saved/)).toBeVisible();
  expect(server.read('tutorial-1/tutorial-1-2d.toml')).toContain('1.75');
  await page.getByRole('tab', { name: 'Runs' }).click();
  await expect(page.locator('li.run')).toContainText('Done');
});
