// The page is never wider than the window.

import type { Page } from '@playwright/test';
import { backToModel, openExample, openForm } from '../support/steps';
import { expect, test } from '../support/workbench';

const widths = (page: Page) => page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);

async function rename(page: Page, thing: RegExp, name: string) {
  await openForm(page, thing);
  await page.getByLabel('Name', { exact: true }).fill(name);
  await page.getByLabel('Name', { exact: true }).press('Tab');
  await backToModel(page);
}

test('long names fit into narrow windows', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await rename(page, /^Project/, 'N'.repeat(300));
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(page.locator('.results-run')).toHaveText('N'.repeat(300));
  await rename(page, /^Line at/, 'A name that goes on and on, '.repeat(8));
  // The rows of the outline still show their details.
  for (const detail of ['collector, 3.5 m', 'by segments', 'line, 50 rocks'])
    await expect(page.getByText(detail, { exact: true })).toBeInViewport({ ratio: 1 });
  for (const width of [1280, 1024, 800, 640, 320]) {
    await page.setViewportSize({ width, height: 800 });
    await expect.poll(() => widths(page)).toEqual([width, width]);
  }
});

test('a popover stays within the view', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await page.setViewportSize({ width: 800, height: 800 });
  await page.locator('summary').filter({ hasText: 'Filter' }).click();
  const [panel, picture] = [page.locator('.popover[open] .content'), page.locator('.picture')];
  const isInside = async () => {
    const [inner, outer] = [(await panel.boundingBox())!, (await picture.boundingBox())!];
    const isAlong = inner.x >= outer.x && inner.x + inner.width <= outer.x + outer.width;
    return isAlong && inner.y + inner.height <= outer.y + outer.height;
  };
  await expect.poll(isInside).toBe(true);
});

test('in a small window, as at 200 % zoom, the page scrolls and stays usable', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await page.setViewportSize({ width: 683, height: 384 });
  const heightOf = async (selector: string) => (await page.locator(selector).boundingBox())!.height;
  await expect.poll(() => heightOf('.picture')).toBeGreaterThanOrEqual(260);
  expect(await heightOf('.side')).toBeGreaterThanOrEqual(360);
  expect(await heightOf('.results-body')).toBeGreaterThanOrEqual(200);
  const distance = page.getByRole('button', { name: 'Distance' });
  await expect(distance).toBeHidden();
  await page.getByRole('button', { name: 'View tools' }).click();
  await expect(distance).toBeVisible();
  await openForm(page, /^Type One/);
  const name = page.getByLabel('Name', { exact: true });
  await name.scrollIntoViewIfNeeded();
  await expect(name).toBeInViewport({ ratio: 1 });
  await page.setViewportSize({ width: 1366, height: 384 });
  await expect.poll(() => heightOf('.workbench')).toBeGreaterThanOrEqual(560);
});
