// Results state their version of the project, their population and their units.

import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { cellsOf, rowsOf } from '../support/table';
import { fillField, openExample, openForm, openProject, runIsShown } from '../support/steps';
import { expect, test } from '../support/workbench';

const oldResults = (page: Page) => page.getByText('These results are from an earlier version of the project.');

test('outdated results are marked until the project matches them again', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await expect(oldResults(page)).toHaveCount(0);
  await openForm(page, /^Type One/);
  await fillField(page, 'Roughness: mean', '9');
  await expect(oldResults(page)).toBeVisible();
  await expect(page.getByText('Trajectories from an earlier version of the project')).toBeVisible();

  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(oldResults(page)).toHaveCount(0);
  await page.getByRole('button', { name: 'Redo' }).click();
  await page.getByRole('button', { name: 'Compute again' }).click();
  await expect(oldResults(page)).toHaveCount(0);
  await expect(page.getByText('Trajectories from an earlier version of the project')).toHaveCount(0);

  // Now the results are from the later version.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(oldResults(page)).toBeVisible();
});

test('energies are shown in kJ with all digits and saved in J', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  const runs = await page.evaluate(async () => (await fetch('/api/runs')).json());
  const summary = JSON.parse(server.read(`${runs.runs[0].folder}/summary.json`));
  const { mean, sample_variance, count } = summary.statistics.max_ke_J;
  await page.getByRole('tab', { name: 'Overview' }).click();
  const table = page.getByRole('region', { name: /Statistics over all rocks/ });
  const heading = table.getByRole('columnheader', { name: 'Maximum total kinetic energy' });
  await expect(heading).toContainText('kJ');
  await page.getByRole('checkbox', { name: 'All digits' }).check();
  const cells = await cellsOf(table);
  const column = (await table.getByRole('columnheader').allTextContents()).findIndex((text) => /kinetic/.test(text));
  const shown = (figure: string) => Number(cells.find(([name]) => name === figure)![column]);
  const close = (a: number, b: number) => expect(Math.abs(a / b - 1)).toBeLessThan(1e-14);
  close(shown('Mean'), mean / 1e3);
  close(shown('Sample variance'), sample_variance / 1e6);
  expect(shown('Count')).toBe(count);

  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('.data-table').filter({ has: table }).getByRole('button', { name: 'CSV' }).click(),
  ]);
  const saved = rowsOf(readFileSync(await download.path(), 'utf8'));
  expect(saved.find(({ figure }) => figure === 'Mean')!.max_ke_J).toBe(String(mean));

  await page.getByRole('tab', { name: 'Distributions' }).click();
  await expect(page.getByLabel('Quantity')).toContainText('Maximum total kinetic energy [kJ]');
  await expect(page.getByLabel('Quantity')).not.toContainText('[J]');
});

test('statistics of a barrier state their population', async ({ workbench: page, server }) => {
  test.setTimeout(180_000);
  // With lines so low that rocks also pass above them.
  server.copyExample('maungawhau');
  const file = 'maungawhau/barrier-design.toml';
  server.write(file, server.read(file).replaceAll('height_m = 5', 'height_m = 2').replace('rocks = 20000', 'rocks = 2000'));
  await page.reload();
  await openProject(page, 'barrier-design.toml');
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await runIsShown(page);
  const runs = await page.evaluate(async () => (await fetch('/api/runs')).json());
  const { barriers, design } = JSON.parse(server.read(`${runs.runs[0].folder}/summary.json`)) as {
    barriers: { name: string; hits: number; passed_above: number }[];
    design: { lines: { name: string; rocks: number }[] };
  };
  const line = barriers.find(({ passed_above }) => passed_above > 1)!;
  await page.getByRole('tab', { name: 'Barriers' }).click();
  await page.getByRole('combobox', { name: /^Barrier/ }).selectOption(line.name);
  const [hits, above] = [line.hits, line.passed_above].map((count) => count.toLocaleString('en'));
  const caption = `Statistics of ${hits} hits; ${above} rocks passed above the top and are not included`;
  await expect(page.getByRole('heading', { name: caption })).toBeVisible();
  const crossed = design.lines.find(({ name }) => name === line.name)!.rocks.toLocaleString('en');
  const designed = page.getByRole('region', { name: `Design percentiles of all ${crossed} rocks that crossed its line` });
  await expect(designed.getByRole('row', { name: /^Total kinetic energy kJ/ }).first()).toBeVisible();
  await expect(page.getByRole('region', { name: 'Requirements of the standard' })).toContainText('kJ');
});

test('a section has envelopes instead of maps, with the numbers of the file', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await expect(page.getByRole('tab', { name: 'Maps' })).toHaveCount(0);
  await page.getByRole('tab', { name: 'Envelopes' }).click();
  await page.getByLabel('Quantity along the section').selectOption('Velocity [m/s]');
  await expect(page.getByRole('img', { name: /^Velocity \[m\/s\] in cells along the section/ })).toBeVisible();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('group', { name: 'Save: Along the section' }).getByRole('button', { name: 'CSV' }).click(),
  ]);
  const saved = rowsOf(readFileSync(await download.path(), 'utf8'));
  const runs = await page.evaluate(async () => (await fetch('/api/runs')).json());
  const file = rowsOf(server.read(`${runs.runs[0].folder}/envelopes.csv`));
  expect(saved.map((row) => [row.x_m, row.velocity_max_m_s])).toEqual(file.map((row) => [row.x_m, row.velocity_max_m_s]));
});
