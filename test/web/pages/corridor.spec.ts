// Trajectories in ground sections, and 2D projects made from them.

import type { Page } from '@playwright/test';
import { openExample, runCard, computeWith } from '../support/steps';
import { expect, test } from '../support/workbench';

const cell = (page: Page, column: string, row: number) => page.getByRole('textbox', { name: `${column}, row ${row}`, exact: true });

/// Types the points of the section.
async function typeSection(page: Page, points: readonly (readonly [number, number])[]) {
  await page.getByRole('button', { name: 'Section', exact: true }).click();
  await page.keyboard.press('Escape');
  for (const [k, [x, y]] of points.entries()) {
    await cell(page, 'x', k + 1).fill(String(x));
    await cell(page, 'y', k + 1).fill(String(y));
    await cell(page, 'y', k + 1).press('Tab');
  }
}
const count = (page: Page) => page.locator('.section-plot figcaption').getByRole('status');

/// The number of rocks with a path point within `width` of y = `at` while x is in a range, by the paths of the server.
async function rocksBeside(page: Page, at: number, width: number): Promise<number> {
  return page.evaluate(
    async ([at, width]) => {
      const { runs } = await (await fetch('/api/runs')).json();
      const text = await (await fetch(`/api/runs/${runs[0].id}/files/paths.csv`)).text();
      const [head, ...lines] = text.trim().split('\n').map((line) => line.split(','));
      const [rock, y] = [head!.indexOf('rock'), head!.indexOf('y_m')];
      return new Set(lines.filter((line) => Math.abs(Number(line[y]) - at) <= width).map((line) => line[rock])).size;
    },
    [at, width] as const,
  );
}

test('a section has the trajectories of its corridor, as the filter leaves them', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  // Rocks of this example keep their y.
  await typeSection(page, [[0.2, 25], [25.8, 25]]);
  await expect(page.getByRole('img', { name: /^Elevation of the ground/ })).toBeVisible();
  const [ten, three] = [await rocksBeside(page, 25, 10), await rocksBeside(page, 25, 3)];
  expect(three).toBeGreaterThan(0);
  expect(three).toBeLessThan(ten);
  await expect(count(page)).toContainText(`${ten} trajectories`);
  await expect(page.locator('.section-plot path.trace').first()).toBeAttached();
  await page.getByLabel('Half width of the corridor [m]').fill('3');
  await page.getByLabel('Half width of the corridor [m]').press('Tab');
  await expect(count(page)).toContainText(`${three} trajector`);

  await page.locator('summary').filter({ hasText: 'Filter' }).click();
  await page.getByLabel('At least').fill('1000000');
  await page.getByLabel('At least').press('Tab');
  await page.keyboard.press('Escape');
  await expect(count(page)).toContainText('0 trajectories');
  await expect(page.locator('.section-plot path.trace')).toHaveCount(0);
});

test('a section becomes a 2D project that computes', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await typeSection(page, [[0.2, 25], [25.8, 25]]);
  await page.getByRole('button', { name: 'Make a 2D project' }).click();
  await expect(page.getByText(/^Opened tutorial-1\/tutorial-1-3d-section\.toml/)).toBeVisible();
  const text = server.read('tutorial-1/tutorial-1-3d-section.toml');
  expect(text).not.toContain('width_m');
  // The vertices between the ends of the line, with x along it, and one material for each segment.
  expect(text).toContain('section = [[0, -0.787], [2.9, -12.2], [6.5, -12.2], [9.6, -24.4], [13.2, -25], [25.6, -22.54]]');
  expect(text).toContain('segments = ["Type One", "Type Two", "Type One", "Type Three", "Type Three"]');
  const original = server.read('tutorial-1/tutorial-1-3d.toml');
  for (const line of original.split('\n').filter((each) => /restitution/.test(each))) expect(text).toContain(line);
  await expect(page.getByText(/^\d+ errors?/)).toHaveCount(0);
  await computeWith(page, 'in section', 200);
  await page.getByRole('tab', { name: 'Runs' }).click();
  await expect(runCard(page, 'in section')).toContainText('200', { timeout: 30_000 });
  await expect(page.getByRole('group', { name: 'Playback' })).toBeVisible({ timeout: 30_000 });
  await expect(page.getByRole('img', { name: /^The slope in section, 1 seeders/ })).toBeVisible();
});
