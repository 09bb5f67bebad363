// Ground sections: drawn, typed, and updated when the model changes.

import type { Page, Response } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { findings } from '../support/findings';
import { rowsOf } from '../support/table';
import { expect, sources, test } from '../support/workbench';

async function openValley(page: Page) {
  await page.getByLabel('Terrain file').setInputFiles(join(sources, 'examples/first-gis-run/valley.tif'));
  await expect(page.getByText(/Elevation, m/)).toBeVisible({ timeout: 30_000 });
  await page.keyboard.press('Escape');
}

const isSection = (response: Response) => /\/api\/models\/\w+\/section$/.test(response.url());
const cell = (page: Page, column: string, row: number) => page.getByRole('textbox', { name: `${column}, row ${row}`, exact: true });

/// The saved table of the plot.
async function savedRows(page: Page) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('group', { name: 'Save: Ground along the line' }).getByRole('button', { name: 'CSV' }).click(),
  ]);
  expect(download.suggestedFilename()).toBe('valley-section.csv');
  return rowsOf(readFileSync(await download.path(), 'utf8'));
}

test('a drawn line gives the ground along it, with the elevations of the engine', async ({ workbench: page, server }) => {
  await openValley(page);
  const picture = page.getByRole('application', { name: /Model in three dimensions/ });
  await picture.focus();
  await picture.press('2'); // plan
  const { height } = (await picture.boundingBox())!;
  await page.getByRole('button', { name: 'Section', exact: true }).click();
  await expect(page.getByRole('tabpanel', { name: 'Section' })).toBeVisible();
  // The panel makes the picture smaller, with a delay if drawing is slow.
  await expect.poll(async () => (await picture.boundingBox())!.height).toBeLessThan(height);
  const box = (await picture.boundingBox())!;
  for (const [x, y] of [
    [0.4, 0.6],
    [0.5, 0.5],
    [0.55, 0.52],
    [0.55, 0.65],
  ] as const)
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  await page.keyboard.press('Backspace');
  const answered = page.waitForResponse(isSection);
  await page.keyboard.press('Enter');
  const model = /models\/(\w+)/.exec((await answered).url())![1]!;
  await expect(page.getByRole('img', { name: /^Elevation of the ground/ })).toBeVisible();
  await expect(page.getByRole('table', { name: 'Line of the section' }).getByRole('button', { name: /^Delete row/ })).toHaveCount(3);

  const rows = await savedRows(page);
  expect(rows.length).toBeGreaterThan(20);
  const points = rows.map(({ x_m, y_m }) => [Number(x_m), Number(y_m)]);
  const { z } = await page.evaluate(
    async ([id, points]) => {
      const request = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ points }) };
      return (await fetch(`/api/models/${id}/elevations`, request)).json();
    },
    [model, points] as const,
  );
  // At an edge of the terrain the elevation may be that of the adjacent triangle, some micrometres away.
  rows.forEach(({ z_m }, k) => expect(Math.abs(Number(z_m) - z[k]), `row ${k + 1}`).toBeLessThan(1e-4));
  const way = rows.map(({ distance_m }) => Number(distance_m));
  expect(way[0]).toBe(0);
  let along = 0;
  points.forEach(([x, y], k) => {
    if (k > 0) along += Math.hypot(x! - points[k - 1]![0]!, y! - points[k - 1]![1]!);
    expect(Math.abs(way[k]! - along)).toBeLessThan(1e-6);
  });

  // The line is not part of the project and stays when the model changes.
  const again = page.waitForResponse(isSection);
  await page.getByRole('button', { name: '+ Add material' }).click();
  expect((await again).url()).not.toContain(model);
  expect(await savedRows(page)).toEqual(rows);
  await page.keyboard.press('Control+s');
  await expect(page.getByText(/^Saved/)).toBeVisible();
  expect(server.read('valley.toml')).not.toContain(rows[0]!.x_m!);
});

test('a typed line is followed by keys, and its end outside the terrain is reported', async ({ workbench: page }) => {
  await openValley(page);
  await page.getByRole('button', { name: 'Section', exact: true }).click();
  await page.keyboard.press('Escape');
  // From within the terrain to far outside.
  const answered = page.waitForResponse(isSection);
  for (const [row, x] of [652375.5, 700000].entries()) {
    await cell(page, 'x', row + 1).fill(String(x));
    await cell(page, 'y', row + 1).fill('5234275.25');
    await cell(page, 'y', row + 1).press('Tab');
  }
  const tiles = (await answered).url().replace(/section$/, 'tiles');
  const { origin, cell: size, columns } = await page.evaluate(async (url) => (await fetch(url)).json(), tiles);
  await expect(page.getByText(/^No terrain from .* to the end\.$/)).toBeVisible();
  const rows = await savedRows(page);
  expect(Number(rows.at(-1)!.x_m)).toBeCloseTo(origin[0] + (columns - 1) * size[0], 6);
  expect(rows.at(-1)!.z_m).toBe('');

  const slider = page.getByRole('slider', { name: 'Position' });
  await slider.focus();
  await slider.press('ArrowRight');
  const { distance_m, z_m, x_m, y_m } = rows[1]!;
  const two = (text?: string) => Number(text).toFixed(2);
  await expect(slider).toHaveAttribute('aria-valuetext', `${two(distance_m)} m along, z ${two(z_m)} m, x ${two(x_m)} y ${two(y_m)} m`);

  expect(await findings(page, '.results')).toEqual([]);
  await page.getByRole('button', { name: 'Remove', exact: true }).click();
  await expect(page.getByRole('region', { name: 'Results' })).toBeHidden();
});

test('a new section shows a hundred metres', async ({ workbench: page }) => {
  await page.getByRole('button', { name: 'Section, 2D' }).click();
  const box = (await page.getByRole('img', { name: /^The slope in section/ }).boundingBox())!;
  const xAt = async (share: number) => {
    await page.mouse.move(box.x + share * box.width, box.y + 0.5 * box.height);
    await expect(page.locator('.status-line .mono')).toContainText(/x -?[\d.]+ z/);
    await page.waitForTimeout(100); // until the next frame
    return Number(/x (-?[\d.]+)/.exec((await page.locator('.status-line .mono').textContent())!)![1]);
  };
  const [left, right] = [await xAt(0.05), await xAt(0.95)];
  expect(right - left).toBeGreaterThan(90);
  expect(right - left).toBeLessThan(130);
});
