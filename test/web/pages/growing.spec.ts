// What a run has found so far is shown while it goes on, as partial.

import { computeWith, openExample, runCard } from '../support/steps';
import { stillShot, viewShot } from '../support/pixels';
import { expect, test } from '../support/workbench';

test('trajectories and shares grow while a run goes on', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await computeWith(page, 'Long', 50_000_000);
  const growing = page.getByText(/^In progress: some of the trajectories of the first [\d,]+ of 50,000,000 rocks$/);
  await expect(growing).toBeVisible();
  await expect(page.getByRole('group', { name: 'Playback' })).toHaveCount(0);
  const results = page.getByRole('region', { name: 'Results' });
  await expect(results.getByRole('status')).toContainText('so these shares may differ from the final ones');
  const table = results.getByRole('region', { name: 'End reasons' }).getByRole('table');
  await expect(table.getByRole('columnheader')).toContainText(['End reason', 'Rocks', 'Share', '95 % interval: from', 'to']);
  await expect(results.getByRole('region', { name: 'Rocks that hit barriers' })).toContainText('Line at 15 m');

  const done = async () => Number(/first ([\d,]+) of/.exec((await growing.textContent())!)![1]!.replaceAll(',', ''));
  const first = await done();
  expect(first).toBeGreaterThan(0);
  await expect.poll(done).toBeGreaterThan(first);
  const rows = await table.locator('tbody tr').evaluateAll((list) => list.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));
  const shares = rows.map(([, , share, low, high]) => [share, low, high].map(Number));
  for (const [share, low, high] of shares) expect(low! <= share! && share! <= high!).toBe(true);
  expect(Math.abs(shares.reduce((sum, [share]) => sum + share!, 0) - 100)).toBeLessThan(0.5);

  await runCard(page, 'Long').or(page.getByRole('banner')).getByRole('button', { name: 'Stop' }).first().click();
  await expect(page.getByRole('group', { name: 'Playback' })).toBeVisible({ timeout: 60_000 });
  await expect(growing).toHaveCount(0);
  await expect(results).toContainText('the run was stopped');
});

test('trajectories grow in 3D', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await page.getByRole('tab', { name: 'Runs' }).click();
  const before = await stillShot(page);
  await computeWith(page, 'Long', 5_000_000);
  await expect(page.getByText(/^In progress: some of the trajectories of the first/)).toBeVisible();
  await expect.poll(async () => (await viewShot(page)).equals(before)).toBe(false);
  await runCard(page, 'Long').getByRole('button', { name: 'Stop' }).click();
  await expect(page.getByRole('group', { name: 'Playback' })).toBeVisible({ timeout: 60_000 });
});
