// Runs that ended early: their results, and what is missing.

import { computeWith, openExample, runCard, runIsShown } from '../support/steps';
import { expect, test } from '../support/workbench';

test('a run whose server was killed has partial results', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Runs' }).click();
  await computeWith(page, 'Long', 50_000_000); // some of the first rocks have trajectories, even on a slow machine
  const long = runCard(page, 'Long');
  await expect(long.getByRole('progressbar')).toBeVisible();
  const { runs } = await page.evaluate(async () => (await fetch('/api/runs')).json());
  await expect.poll(() => server.has(`${runs[0].folder}/run.state`), { timeout: 30_000 }).toBe(true);
  await server.end('SIGKILL');
  await server.startFor(page);
  await expect(long).toContainText(/Interrupted, [\d,]+ of/, { timeout: 30_000 });
  await page.getByRole('button', { name: 'Write partial results' }).click();
  await runIsShown(page);
  await page.getByRole('tab', { name: 'Overview' }).click();
  await expect(page.getByText(/of 50,000,000: the run was stopped/)).toBeVisible();
  await expect(long.getByRole('button', { name: 'Resume' })).toBeVisible();
});

test('a run that was stopped while waiting requests no results', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const missed: string[] = [];
  page.on('response', (response) => response.status() === 404 && missed.push(response.url()));
  await page.getByRole('tab', { name: 'Runs' }).click();
  await computeWith(page, 'Long', 50_000_000);
  await expect(runCard(page, 'Long').getByRole('progressbar')).toBeVisible();
  await computeWith(page, 'Next', 50);
  const next = runCard(page, 'Next');
  await expect(page.getByText('This run is waiting for other runs to finish.')).toBeVisible();
  await next.getByRole('button', { name: 'Stop' }).click();
  const why = page.getByText('This run was stopped before any rock was finished.');
  await expect(why).toBeVisible();
  await expect(next).toContainText('Stopped');
  expect(missed).toEqual([]);

  await runCard(page, 'Long').getByRole('button', { name: 'Stop' }).click();
  await page.getByRole('region', { name: 'Results' }).getByRole('button', { name: 'Resume' }).click();
  await runIsShown(page);
  await expect(next).toContainText('Done');
  await expect(why).toHaveCount(0);
});
