// Comparing two runs.

import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { computeWith, fillField, openExample, openForm, runCard, runIsShown } from '../support/steps';
import { cellsOf, rowsOf } from '../support/table';
import { pixelsLike, type Rgb } from '../support/pixels';
import { expect, test } from '../support/workbench';

/// Opens an example with 50 rocks, and compares it with a run of 300 rocks with a higher restitution.
async function compareTwo(page: Page, example: string) {
  await openExample(page, example);
  await openForm(page, /^Type One/);
  await fillField(page, 'Normal restitution: mean', '0.7');
  await computeWith(page, 'Lively', 300);
  await expect(runCard(page, 'Lively')).toContainText('Done');
  await runIsShown(page);
  await runCard(page, 'Tutorial 1').getByRole('button', { name: 'Compare' }).click();
  await page.getByRole('tab', { name: 'Compare' }).click();
  await expect(page.getByRole('img', { name: /^Histogram of runout on plan/ })).toBeVisible();
}

async function saved(page: Page, figure: string, nth = 0) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('group', { name: `Save: ${figure}` }).nth(nth).getByRole('button', { name: 'CSV' }).click(),
  ]);
  const text = readFileSync(await download.path(), 'utf8');
  return rowsOf(text.replace(/"[^"]*"/g, (name) => name.replace(/[",]/g, '')));
}

test('histograms of two runs have the same bins and show shares of each run', async ({ workbench: page }) => {
  await compareTwo(page, 'Tutorial 1, in 3D');
  const check = (rows: Record<string, string>[], column: string, counts: number[]) => {
    const names = [...new Set(rows.map(({ of }) => of))];
    expect(names).toHaveLength(2);
    const [first, second] = names.map((name) => rows.filter(({ of }) => of === name));
    const edges = (list: typeof rows) => list.map((row) => [row[`${column}_from`], row[`${column}_to`]]);
    expect(edges(first!)).toEqual(edges(second!));
    [first!, second!].forEach((list, k) => {
      if (counts[k]) expect(list.reduce((sum, { count }) => sum + Number(count), 0)).toBe(counts[k]);
      expect(list.reduce((sum, row) => sum + Number(row.share_percent), 0)).toBeCloseTo(100, 9);
    });
  };
  check(await saved(page, 'Histogram'), 'runout_xy_m', [300, 50]);
  check(await saved(page, 'Histogram', 1), 'ke_total_J', []);
  const histogram = page.getByRole('img', { name: /^Histogram of runout on plan/ });
  await expect(histogram.locator('text', { hasText: /^Share of rocks/ })).toBeVisible();
});

test('the comparison with box plots and barriers fits into 1366 pixels', async ({ workbench: page }) => {
  await compareTwo(page, 'Tutorial 1, in 3D');
  await expect(page.getByRole('img', { name: /^Box plots of runout on plan of both runs/ })).toBeVisible();
  const statistics = page.getByRole('region', { name: 'Statistics: Runout on plan [m]' });
  const heads = statistics.getByRole('columnheader');
  await heads.first().scrollIntoViewIfNeeded();
  await expect(heads).toHaveCount(3);
  for (const head of await heads.all()) await expect(head).toBeInViewport({ ratio: 1 });
  const isCutOff = (region: Element) => region.scrollWidth > region.clientWidth;
  expect(await statistics.evaluate(isCutOff)).toBe(false);
  const collectors = page.getByRole('region', { name: 'Collectors', exact: true });
  const names = (await cellsOf(collectors)).map(([barrier, run]) => `${barrier}: ${run}`);
  expect(names).toEqual(['Line at 15 m: Lively', 'Line at 15 m: Tutorial 1, extruded']);
  expect(await collectors.evaluate(isCutOff)).toBe(false);
});

test('trajectories of two compared runs have two colours', async ({ workbench: page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await compareTwo(page, 'Tutorial 1, a section');
  const legend = page.locator('.legend').filter({ hasText: 'Trajectories of two runs' });
  await expect(legend.locator('li')).toHaveText([/Lively/, /Tutorial 1, section/]);
  const [blue, vermilion, violet] = [[0, 114, 178], [213, 94, 0], [126, 3, 168]] as [Rgb, Rgb, Rgb];
  await expect.poll(async () => (await pixelsLike(page, [blue, vermilion])).every((count) => count > 200)).toBe(true);
  expect((await pixelsLike(page, [violet]))[0]).toBeLessThan(50);
});
