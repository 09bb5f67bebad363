// Pictures for print: complete, legible, with legends, at print resolution.

import type { Locator, Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { openExample } from '../support/steps';
import { expect, test } from '../support/workbench';

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}
const boxOf = async (place: Locator): Promise<Box> => (await place.boundingBox())!;
const areApart = (a: Box, b: Box) =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

/// The size and resolution [dpi] of a PNG.
function readPng(bytes: Buffer) {
  let [at, density] = [8, 0];
  while (at < bytes.length) {
    const [length, name] = [bytes.readUInt32BE(at), bytes.toString('latin1', at + 4, at + 8)];
    if (name === 'pHYs' && bytes[at + 16] === 1) density = bytes.readUInt32BE(at + 8) * 0.0254;
    at += length + 12;
  }
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20), density };
}

async function savedBy(page: Page, button: Locator): Promise<Buffer> {
  const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), button.click()]);
  return readFileSync(await download.path());
}

/// Counts transparent and dark pixels of a PNG.
const countPixels = (page: Page, bytes: Buffer) =>
  page.evaluate(async (text) => {
    const data = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([data], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const pen = canvas.getContext('2d', { willReadFrequently: true })!;
    pen.drawImage(picture, 0, 0);
    const { data: pixels } = pen.getImageData(0, 0, picture.width, picture.height);
    const found = { clear: 0, dark: 0, inked: { title: 0, column: 0 } };
    for (let k = 0; k < pixels.length; k += 4) {
      if (pixels[k + 3]! < 255) ++found.clear;
      if (pixels[k]! + pixels[k + 1]! + pixels[k + 2]! > 240) continue;
      ++found.dark;
      const [x, y] = [(k / 4) % picture.width, Math.floor(k / 4 / picture.width)];
      if (y < 0.06 * picture.height) ++found.inked.title;
      else if (x > 0.8 * picture.width) ++found.inked.column;
    }
    return found;
  }, bytes.toString('base64'));

for (const [title, what] of [
  ['Tutorial 1, a section', 'the section'],
  ['Tutorial 1, in 3D', 'the scene'],
] as const)
  test(`a saved picture of ${what} is an opaque page for print with title and legend`, async ({ workbench: page }) => {
    test.setTimeout(180_000);
    await openExample(page, title);
    const bytes = await savedBy(page, page.getByRole('button', { name: 'Picture', exact: true }));
    const { width, height, density } = readPng(bytes);
    expect(Math.round(density)).toBe(300);
    expect(width).toBeGreaterThan(3000);
    expect(height).toBeGreaterThan(2000);
    const { clear, inked } = await countPixels(page, bytes);
    expect(clear).toBe(0);
    expect(inked.title).toBeGreaterThan(500);
    expect(inked.column).toBeGreaterThan(500);
  });

test('a saved plot has 300 dpi and its title', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Distributions' }).click();
  const group = page.getByRole('group', { name: 'Save: Histogram' });
  const [download] = await Promise.all([page.waitForEvent('download'), group.getByRole('button', { name: 'SVG' }).click()]);
  expect(readFileSync(await download.path(), 'utf8')).toContain('Histogram: Tutorial 1, section</text>');
  const { width, density } = readPng(await savedBy(page, group.getByRole('button', { name: 'PNG' })));
  expect(Math.round(density)).toBe(300);
  expect(width).toBeGreaterThan(900);
});

test('a map shows classes, range and the value under the pointer, and hides trajectories', async ({ workbench: page }) => {
  test.setTimeout(180_000);
  await openExample(page, 'Maungawhau');
  await page.getByRole('tab', { name: 'Maps' }).click();
  await expect(page.getByText('Speed, m/s')).toBeVisible();
  await page.getByRole('group', { name: 'Total kinetic energy' }).getByRole('button', { name: 'maximum over all rocks' }).click();
  await expect(page.getByRole('link', { name: 'energy_total_max_kJ.tif' })).toBeVisible();
  const legend = page.locator('.legend.classes');
  await expect(legend.locator('figcaption')).toContainText('kJ');
  for (const text of ['< 30', '30 – 100', '100 – 300', '300 – 1,000', '1,000 – 3,000', '≥ 3,000'])
    await expect(legend.getByText(text, { exact: true })).toBeVisible();
  await expect(legend).toContainText(/values from [\d.]+ to [\d,.]+ kJ/);
  await expect(page.getByText('Speed, m/s')).toHaveCount(0);
  await page.getByRole('checkbox', { name: 'Trajectories over the map' }).check();
  await expect(page.getByText('Speed, m/s')).toBeVisible();

  // Below the rim there is a value, far from it there is none.
  const scene = page.getByRole('application', { name: /Model in three dimensions/ });
  await scene.focus();
  await scene.press('2');
  const { x, y, width, height } = await boxOf(scene);
  const value = page.locator('.map-value');
  const seen = new Set<string>();
  for (let k = 0; k < 60 && seen.size < 2; ++k) {
    await page.mouse.move(x + width * (0.4 + 0.2 * ((k % 6) / 6)), y + height * (0.94 - 0.08 * Math.floor(k / 6)));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const text = (await value.count()) > 0 ? await value.textContent() : null;
    if (text) seen.add(/[\d.,]+ kJ$/.test(text) ? 'value' : text.replace(/.*: /, ''));
  }
  expect([...seen].sort()).toEqual(['no rock', 'value']);
});

test.describe(() => {
  test.use({ answersFirst: true });
  test('after a run the slope still fills the free part of the view', async ({ workbench: page }) => {
    await openExample(page, 'Tutorial 1, a section');
    const { height } = await boxOf(page.locator('.picture'));
    expect(height).toBeGreaterThan(370); // of 768, below the answers
    // The slope is as high as toolbar, axis numbers and status line allow.
    const status = page.locator('.status-line');
    const canvas = page.getByRole('img', { name: /^The slope in section/ });
    const box = await boxOf(canvas);
    const zAt = async (top: number) => {
      await page.mouse.move(box.x + box.width / 2, box.y + top);
      await expect(status).toContainText(/z /);
      return Number(/z (\S+)/.exec((await status.textContent())!)![1]);
    };
    const metresPerPixel = ((await zAt(100)) - (await zAt(300))) / 200;
    expect(25 / metresPerPixel).toBeGreaterThan(0.62 * box.height); // it is 25 m high; a row of buttons is above
  });
});

test('the hint of a tool does not cover the ground', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await page.getByRole('button', { name: 'Distance' }).click();
  const [hint, status, bar] = [page.locator('.tool-hint'), page.locator('.status-line'), page.locator('.view-bar')];
  await expect(hint).toBeVisible();
  const [inner, line] = [await boxOf(hint), await boxOf(status)];
  expect(inner.y).toBeGreaterThanOrEqual(line.y);
  expect(inner.y + inner.height).toBeLessThanOrEqual(line.y + line.height + 1);
  expect(areApart(inner, await boxOf(bar))).toBe(true);
  expect(line.height).toBeLessThan(40);
});
