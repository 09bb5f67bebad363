// Observed rocks: imported, seen, calibrated with, and predicted.

import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { seriousFindings } from '../support/findings';
import { cellsOf } from '../support/table';
import { computeWith, openProject, projectText, runIsShown } from '../support/steps';
import { stillShot } from '../support/pixels';
import { expect, sources, test, type Server } from '../support/workbench';

const example = (name: string) => readFileSync(join(sources, 'examples/calibration', name), 'utf8');

async function openSlope(page: Page, server: Server) {
  server.write('slope.toml', example('slope.toml'));
  await page.reload();
  await openProject(page, 'slope.toml');
  await page.getByRole('tab', { name: 'Calibrate' }).click();
}

const importStops = (page: Page, name: string, text: string) =>
  page.getByLabel('Import stops').setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });

async function seek(page: Page, title: string) {
  await page.getByLabel('Add a parameter').selectOption({ label: title });
}

async function setStudy(page: Page, numbers: Record<string, string>) {
  for (const [name, value] of Object.entries(numbers)) {
    const field = page.getByLabel(`${name} of the study`);
    await field.fill(value);
    await field.press('Tab');
  }
}

test('observed stops are imported, seen, calibrated with, and predicted', async ({ workbench: page, server }) => {
  test.setTimeout(180_000);
  page.setDefaultTimeout(20_000);
  await openSlope(page, server);
  await expect(page.getByRole('button', { name: 'Calibrate', exact: true })).toBeDisabled();
  const before = await stillShot(page);
  await importStops(page, 'stops.csv', example('stops.csv'));
  await expect(page.getByText('30 places')).toBeVisible();
  expect(server.read('stops.csv')).toBe(example('stops.csv'));
  await expect(page.getByText('30 stops')).toBeVisible(); // the legend
  const seen = await stillShot(page);
  expect(seen.equals(before)).toBe(false);
  await page.locator('summary').filter({ hasText: 'Layers' }).click();
  await page.getByLabel('Observed rocks').uncheck();
  await expect(page.getByText('30 stops')).toHaveCount(0);
  await page.getByLabel('Observed rocks').check();
  await page.keyboard.press('Escape');

  // Beside a run.
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await runIsShown(page);
  await page.getByRole('tab', { name: 'Observed' }).click();
  const distances = page.getByRole('region', { name: /^Energy distance between observed/ });
  await expect(distances).toBeVisible();
  const [row] = await cellsOf(distances);
  expect(row![0]).toBe('x of the end point');
  expect(Number(row![1])).toBeGreaterThan(Number(row![3])); // not by chance: the project's values are a guess

  // Calibrate.
  await seek(page, 'Scree: tangential restitution');
  await seek(page, 'Meadow: friction angle, °');
  await page.getByLabel('Least value of material.Meadow.friction_angle_deg').fill('15');
  await page.getByLabel('Greatest value of material.Meadow.friction_angle_deg').fill('40');
  await page.getByLabel('Greatest value of material.Meadow.friction_angle_deg').press('Tab');
  await setStudy(page, { Rocks: '60', Sets: '200', Rounds: '2', Folds: '2' });
  await page.getByRole('button', { name: 'Calibrate', exact: true }).click();
  const card = page.getByRole('region', { name: 'Calibrations' }).getByRole('listitem');
  await expect(card.getByText('Done')).toBeVisible({ timeout: 90_000 });
  expect(server.read('slope.study.toml')).toContain('path = "material.Meadow.friction_angle_deg"\nrange = [15, 40]');

  // The posterior, also after a reload of the page.
  await page.reload();
  await page.getByRole('tab', { name: 'Calibrate' }).click();
  await expect(page.getByLabel('Sets of the study')).toHaveValue('200');
  await card.getByRole('button', { name: 'Results' }).click();
  const known = page.getByRole('region', { name: 'What is known of each parameter' });
  await expect(known).toBeVisible();
  const rows = await cellsOf(known);
  expect(rows.map(([name]) => name)).toEqual(['Scree: tangential restitution', 'Meadow: friction angle [°]']);
  for (const cells of rows) {
    const [low, median, high] = cells.slice(3, 6).map(Number);
    expect(low!).toBeLessThan(median!);
    expect(median!).toBeLessThan(high!);
  }
  await expect(page.getByRole('img', { name: /^Prior and posterior of Scree: tangential restitution/ })).toBeVisible();
  await expect(page.getByRole('img', { name: /^Cumulative distribution of runout, stops/ })).toBeVisible();
  await expect(page.getByRole('img', { name: /^Sets of the posterior by/ })).toBeVisible();
  await expect(page.getByRole('region', { name: /held out/ })).toBeVisible();

  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    expect(await seriousFindings(page)).toEqual([]);
  }

  // Predictions.
  await page.getByRole('button', { name: 'Predict with the posterior' }).click();
  await expect(page.getByText('Opened slope-posterior.toml.')).toBeVisible();
  expect(server.read('slope-posterior.toml')).toContain('parameters = "slope-posterior.csv"');
  expect(server.read('slope-posterior.csv')).toContain('weight,score,material.Scree.tangential_restitution');
  await computeWith(page, 'Prediction', 2000);
  await runIsShown(page);
  await page.getByRole('tab', { name: 'Uncertainty' }).click();
  const bands = page.getByRole('region', { name: /^Figures with their 90 % ranges over 50 ensembles/ });
  await expect(bands).toBeVisible();
  const [figure] = await cellsOf(bands);
  const [value, low, high] = figure!.slice(2, 5).map(Number);
  expect(low!).toBeLessThan(value!);
  expect(high!).toBeGreaterThan(value!);
  await page.getByRole('tab', { name: 'Observed' }).click(); // the observations came along
  await expect(distances).toBeVisible();
});

test('the best fit is a project of its own', async ({ workbench: page, server }) => {
  await openSlope(page, server);
  await importStops(page, 'stops.csv', example('stops.csv'));
  await expect(page.getByText('30 places')).toBeVisible();
  await seek(page, 'Scree: tangential restitution');
  await setStudy(page, { Rocks: '40', Sets: '60' });
  await page.getByRole('button', { name: 'Calibrate', exact: true }).click();
  await page.getByRole('button', { name: 'Results' }).click({ timeout: 60_000 });
  await page.getByRole('button', { name: 'Open the best fit' }).click();
  await expect(page.getByText('Opened slope-best.toml.')).toBeVisible();
  const text = await projectText(page);
  const best = /^tangential_restitution = \{ mean = ([\d.]+), /m.exec(text)!;
  expect(Number(best[1])).not.toBe(0.85);
  expect(text).toContain('# The project that examples/calibration/study.toml calibrates'); // comments are kept
  expect(server.read('slope.toml')).toBe(example('slope.toml'));
});

test('bad files and bad studies are refused where they are', async ({ workbench: page, server }) => {
  await openSlope(page, server);
  const observations = page.getByRole('region', { name: 'Observations' });
  await importStops(page, 'far.csv', 'x_m\n80\n900\nnowhere\n');
  await expect(observations.getByRole('alert')).toContainText(['far.csv:4']);
  await expect(observations.getByText(/x_m is "nowhere"/)).toBeVisible();
  // A corrected file of the same name.
  await importStops(page, 'far.csv', 'x_m\n80\n900\n');
  await page.getByRole('button', { name: 'Replace' }).click();
  await expect(observations.getByText(/far.csv:3.*900.*outside the terrain/)).toBeVisible();
  await importStops(page, 'far.csv', 'x_m\n80\n90\n70\n');
  await page.getByRole('button', { name: 'Replace' }).click();
  await expect(observations.getByText('3 places')).toBeVisible();
  await expect(observations.getByRole('alert')).toHaveCount(0);

  await seek(page, 'Scree: tangential restitution');
  await page.getByLabel('Least value of material.Scree.tangential_restitution').fill('3');
  await page.getByLabel('Least value of material.Scree.tangential_restitution').press('Tab');
  await setStudy(page, { Rocks: '5' });
  await page.getByRole('button', { name: 'Calibrate', exact: true }).click();
  await expect(page.getByRole('region', { name: 'Parameters' }).getByRole('alert')).toContainText(['range is [3']);
  await expect(page.getByRole('region', { name: 'Study' }).getByRole('alert')).toContainText(['rocks is 5']);
  expect(server.has('slope.study.toml')).toBe(false);

  // A study of another hand is not replaced, but can be opened.
  server.write('slope.study.toml', example('study.toml'));
  await page.getByLabel('Least value of material.Scree.tangential_restitution').fill('0.6');
  await setStudy(page, { Rocks: '40', Sets: '60' });
  await page.getByRole('button', { name: 'Calibrate', exact: true }).click();
  await expect(page.getByText(/slope.study.toml.*already exists/)).toBeVisible();
  await page.reload();
  await page.getByRole('tab', { name: 'Calibrate' }).click();
  await page.getByLabel('Open a study').selectOption('slope.study.toml');
  await expect(page.getByLabel('Sets of the study')).toHaveValue('800');
  await expect(page.getByLabel('Least value of material.Meadow.friction_angle_deg')).toHaveValue('15');
});

test('a calibration is stopped and resumed', async ({ workbench: page, server }) => {
  await openSlope(page, server);
  await importStops(page, 'stops.csv', example('stops.csv'));
  await expect(page.getByText('30 places')).toBeVisible();
  await seek(page, 'Scree: tangential restitution');
  await setStudy(page, { Sets: '100000' });
  await page.getByRole('button', { name: 'Calibrate', exact: true }).click();
  await expect(page.getByText(/ left$/)).toBeVisible({ timeout: 30_000 });
  const list = page.getByRole('region', { name: 'Calibrations' });
  await list.getByRole('button', { name: 'Stop' }).click();
  await expect(list.getByText(/^Stopped|Stopped, /)).toBeVisible();
  await list.getByRole('button', { name: 'Resume' }).click();
  await expect(list.getByText(/Running/)).toBeVisible();
  await list.getByRole('button', { name: 'Stop' }).click();
  await expect(list.getByText(/Stopped/)).toBeVisible();
  await list.getByRole('button', { name: 'Delete…' }).click();
  await page.getByRole('button', { name: 'Delete', exact: true }).click();
  await expect(list).toHaveCount(0);
  expect(server.has('slope.study.toml')).toBe(true);
});
