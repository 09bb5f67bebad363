// The page is never wider than the window.

import type { Page } from '@playwright/test';
import { backToModel, openExample, openForm, toStartPage } from '../support/steps';
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
  await page.getByRole('button', { name: 'View tools' }).click();
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

test('at 150 % zoom on a laptop, tools and legends leave the map free', async ({ workbench: page }) => {
  for (const example of ['Tutorial 1, a section', 'Tutorial 1, in 3D']) {
    await openExample(page, example);
    await page.setViewportSize({ width: 911, height: 512 }); // 1366 by 768 at 150 %
    const boxOf = async (selector: string) => (await page.locator(selector).first().boundingBox())!;
    await expect.poll(async () => (await boxOf('.picture')).height).toBeGreaterThanOrEqual(260);
    const [tools, legend, picture] = [await boxOf('.view-bar'), await boxOf('.legend'), await boxOf('.picture')];
    expect(tools.height).toBeLessThan(40);
    expect(tools.x + tools.width <= legend.x || tools.y + tools.height <= legend.y).toBe(true);
    expect(legend.width * legend.height).toBeLessThan(0.3 * picture.width * picture.height);
    // A chosen tool folds them again, beside its card.
    await page.getByRole('button', { name: 'View tools' }).click();
    await page.getByRole('button', { name: 'Ask a line', exact: true }).click();
    await expect.poll(async () => (await boxOf('.view-bar')).height).toBeLessThan(40);
    await page.getByRole('region', { name: 'Ask a line' }).getByRole('button', { name: 'Close' }).click();
    await page.setViewportSize({ width: 1366, height: 768 });
    await toStartPage(page);
  }
});
