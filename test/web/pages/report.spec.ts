// The report in other units, opened from its file.

import type { Page } from '@playwright/test';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { program, sources } from '../support/workbench';

let folder = '';
const talus = (...options: string[]) => execFileSync(program, options, { cwd: folder, stdio: 'pipe' });
const tutorial = (dimensions: string) => join(sources, `examples/tutorial-1/tutorial-1-${dimensions}.toml`);

test.beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'talus-report-'))));
test.afterEach(() => rmSync(folder, { recursive: true, force: true }));

const openReport = (page: Page, name: string) => page.goto(`file://${folder}/${name}`);
const numberIn = (text: string) => Number(text.replaceAll(',', '').replace('−', '-'));

/// The texts of a table's columns by their titles with units.
async function columnsOf(page: Page, caption: string): Promise<Map<string, string[]>> {
  const table = page.locator('table', { has: page.locator('caption', { hasText: caption }) }).first();
  const [head = [], ...rows] = await table
    .locator('tr')
    .evaluateAll((all) => all.map((row) => [...row.querySelectorAll('th, td')].map((cell) => cell.firstChild?.textContent + (cell.querySelector('.unit')?.textContent ?? ''))));
  return new Map(head.map((title, k) => [title, rows.map((row) => row[k]!)]));
}

/// Numbers at the ticks of a figure's horizontal axis, and its labels.
async function axesOf(page: Page, figure: string) {
  const drawing = page.locator('figure', { has: page.getByRole('heading', { name: figure, exact: true }) }).locator('svg.drawing');
  return {
    ticks: (await drawing.locator('.axis').first().locator('.tick text').allTextContents()).map(numberIn),
    labels: await drawing.locator('.axis-label').allTextContents(),
  };
}

test('a section is drawn and tabled in feet and kip-feet on request', async ({ page }) => {
  talus('run', tutorial('2d'), '-q', '-o', 'out', '--set', 'report.units=us');
  talus('report', 'out', '--units', 'metric', '-o', 'metric.html');
  const statistics = 'Descriptive statistics, one value per rock';
  await openReport(page, 'metric.html');
  const metric = await columnsOf(page, statistics);
  expect((await axesOf(page, 'Section with trajectories')).labels).toEqual(['x [m]', 'z [m]']);
  await expect(page.locator('.unit-note')).toHaveCount(0);

  await openReport(page, 'out/report.html');
  const [names, shown] = [metric.get('')!, await columnsOf(page, statistics)];
  const kipFoot = 1.3558179483; // 1,000 ft lbf in kJ
  for (const [title, unit, displayed, size] of [
    ['End point x', 'm', 'ft', 0.3048],
    ['Runout on plan', 'm', 'ft', 0.3048],
    ['Maximum total kinetic energy', 'kJ', 'kip·ft', kipFoot],
    ['Maximum bounce height (lowest point)', 'm', 'ft', 0.3048],
  ] as const) {
    const [before, after] = [metric.get(`${title} [${unit}]`)!, shown.get(`${title} [${displayed}]`)!];
    const power = (name = '') => (name === 'Sample variance' ? 2 : /Kurtosis|Skewness|Count/.test(name) ? 0 : 1);
    expect(before).toHaveLength(15);
    before.forEach((value, k) => {
      const wanted = numberIn(value) / size ** power(names[k]);
      // Both are rounded to four digits and at most three decimals.
      expect(Math.abs(numberIn(after[k]!) - wanted), `${title}, ${names[k]}`).toBeLessThan(1.5e-3 * Math.abs(wanted) + 6e-3);
    });
  }
  const section = await axesOf(page, 'Section with trajectories');
  expect(section.labels).toEqual(['x [ft]', 'z [ft]']);
  const step = section.ticks[1]! - section.ticks[0]!;
  expect([10, 20, 50]).toContain(step); // round in feet
  expect((await axesOf(page, 'Total kinetic energy along the section')).labels).toEqual(['x [ft]', 'Total kinetic energy [kip·ft]']);
  await expect(page.locator('.scale-bar text').last()).toHaveText(/^[125]0* ft$/);

  // Inputs and saved tables stay metric, and say so.
  await expect(page.locator('.unit-note').first()).toContainText('Inputs and saved tables of values are metric');
  await expect(page.locator('#model')).toContainText('Normal velocity cutoff [m/s]');
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save "Runout" as table of values in metric units' }).click();
  const table = await saving;
  expect(table.suggestedFilename()).toBe('runout-in-metric-units.csv');
  expect(readFileSync(await table.path(), 'utf8')).toMatch(/^of,runout_xy_m_from,runout_xy_m_to,/);
});

test('the reader changes the units of a report; coordinates of a terrain stay', async ({ page }) => {
  talus('run', tutorial('3d'), '-q', '-o', 'out');
  await openReport(page, 'out/report.html');
  await expect(page.locator('#head')).toContainText('Rock model lumped mass, 3D');
  await expect(page.locator('#head')).toContainText('With another rock model');
  await expect(page.locator('#head code')).toHaveText('talus compare PROJECT.toml --models');
  await expect(page.locator('#slope figcaption').last()).toContainText('the lowest to the highest ground under them');
  const body = async () => (await page.locator('main').innerText()).replace(/\s+/g, ' ');
  const metric = await body();
  expect(metric).not.toMatch(/\bft\b/);
  const card = page.locator('main .card').filter({ hasText: 'Mean runout (plan)' });
  const metres = numberIn(/([\d.,]+) m$/.exec(await card.innerText())![1]!);

  const units = page.getByRole('combobox', { name: 'Units' });
  await units.selectOption('US customary');
  await expect(card).toContainText(' ft');
  expect(numberIn(/([\d.,]+) ft$/.exec(await card.innerText())![1]!)).toBeCloseTo(metres / 0.3048, 1);
  await expect(units).toBeFocused();
  expect((await axesOf(page, 'Plan with trajectories')).labels).toEqual(['x [m]', 'y [m]']);
  expect((await axesOf(page, 'Section with trajectories')).labels).toEqual(['Distance along the mean direction of travel [ft]', 'z [ft]']);
  await expect(page.locator('#maps')).toContainText('Velocity, 95 % [ft/s]');
  await expect(page.locator('figcaption', { hasText: 'Contours every' }).first()).toContainText(/Contours every [125]0* ft/);

  await units.selectOption('metric');
  expect(await body()).toBe(metric);
});
