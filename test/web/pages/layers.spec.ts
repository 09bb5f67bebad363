// Reference layers over the terrain, files dropped on the page, and lines to ask taken from the map.

import { crc32, deflateSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { openProject, projectText } from '../support/steps';
import { pixelsLike } from '../support/pixels';
import { pixelOf } from '../support/places';
import { expect, test, type Server } from '../support/workbench';

/// A PNG of one colour.
function png(side: number, colour: readonly number[]): Buffer {
  const chunk = (name: string, content: Buffer) => {
    const all = Buffer.concat([Buffer.from(name), content]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(content.length, 0);
    ends.writeUInt32BE(crc32(all), 4);
    return Buffer.concat([ends.subarray(0, 4), all, ends.subarray(4)]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(side, 0);
  head.writeUInt32BE(side, 4);
  head.set([8, 2, 0, 0, 0], 8);
  const row = Buffer.from([0, ...Array.from({ length: side }, () => colour).flat()]);
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head), chunk('IDAT', deflateSync(Buffer.concat(Array.from({ length: side }, () => row)))), chunk('IEND', Buffer.alloc(0))]);
}

const lines = (crs: string, ...coordinates: number[][][]) =>
  JSON.stringify({
    type: 'FeatureCollection',
    ...(crs && { crs: { type: 'name', properties: { name: crs } } }),
    features: coordinates.map((each, k) => ({ type: 'Feature', properties: { name: `Road ${k + 1}` }, geometry: { type: 'LineString', coordinates: each } })),
  });

/// A slope of 200 m by 200 m in Switzerland that falls to the east.
function write(server: Server) {
  const rows = Array.from({ length: 21 }, () => Array.from({ length: 21 }, (_, k) => 800 - 5 * k).join(' '));
  server.write('slope.asc', `ncols 21\nnrows 21\nxllcenter 2600000\nyllcenter 1200000\ncellsize 10\n${rows.join('\n')}\n`);
  server.write('photo.png', png(20, [230, 20, 200]));
  server.write('photo.pgw', '10\n0\n0\n-10\n2600005\n1200195\n');
  server.write('roads.geojson', lines('EPSG:2056', [[2600100, 1200000], [2600120, 1200200]]));
  server.write(
    'site.toml',
    `[terrain]
raster = "slope.asc"
crs = "EPSG:2056"
[[material]]
name = "Scree"
[[seeder]]
position = [2600020, 1200100, "surface"]
mass_kg = 500
rocks = 5
[[layer]]
file = "photo.png"
[[layer]]
file = "roads.geojson"
colour = "#ffffff"
`,
  );
}

async function open(page: Page, server: Server) {
  write(server);
  await page.reload();
  await openProject(page, 'site.toml');
  await page.locator('.scene canvas').first().press('2'); // plan
}

/// Whether the picture covers most of the terrain.
const isDraped = async (page: Page) => (await pixelsLike(page, [[230, 20, 200]], 80))[0]! > 20_000;

test('a picture is draped over the terrain; a road becomes a line to ask, as does a contour', async ({ workbench: page, server }) => {
  await open(page, server);
  await expect.poll(() => isDraped(page)).toBe(true);
  await page.locator('summary').filter({ hasText: 'Layers' }).click();
  await page.getByRole('checkbox', { name: 'photo' }).uncheck();
  await page.keyboard.press('Escape');
  await expect.poll(() => isDraped(page)).toBe(false);

  await page.getByRole('button', { name: 'Ask a line', exact: true }).click();
  const card = page.getByRole('region', { name: 'Ask a line' });
  const first = card.getByRole('textbox', { name: 'x, row 1', exact: true });
  await card.getByText('Points, x and y [m]').click();
  await card.getByRole('button', { name: 'From a layer' }).click();
  await page.mouse.click(...(await pixelOf(page, [2600110, 1200100])));
  await expect(first).toHaveValue('2600100');
  await card.getByRole('button', { name: 'A contour' }).click();
  await page.mouse.click(...(await pixelOf(page, [2600150, 1200060])));
  await expect.poll(async () => Math.abs(Number(await first.inputValue()) - 2600150)).toBeLessThan(3);
});

const drop = (page: Page, name: string, text: string) =>
  page.evaluate(
    ([called, content]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content!], called!));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, text],
  );
const usesOf = (page: Page, name: string) => page.getByRole('dialog', { name: `What is ${name}?` }).locator('.drop-uses span:first-child').allTextContents();
const nets = lines('', [[7.4392, 46.9515], [7.4392, 46.9523]], [[7.44, 46.9515], [7.4401, 46.9523]]); // degrees

test('no dropped file replaces the terrain unasked', async ({ workbench: page, server }) => {
  await open(page, server);
  const before = server.read('site.toml');
  for (const name of ['cloud.las', 'rock.ply']) {
    await drop(page, name, 'not read before it is chosen');
    await expect.poll(() => usesOf(page, name)).toEqual(['The terrain', 'Only store it']);
    await page.getByRole('dialog', { name: `What is ${name}?` }).getByRole('button', { name: 'Only store it' }).click();
  }
  expect(server.has('cloud.las')).toBe(true);
  expect(await projectText(page)).toBe(before);
});

test('a file dropped before the model is built can be what it can be afterwards', async ({ workbench: page, server }) => {
  write(server);
  await page.reload();
  await page.route('**/api/model', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 2000));
    await route.continue();
  });
  await openProject(page, 'site.toml');
  await drop(page, 'nets.geojson', nets);
  const uses = ['Reference layer', '2 barriers', '2 collectors', 'Release lines', 'A line to ask', 'The terrain', 'Only store it'];
  await expect.poll(() => usesOf(page, 'nets.geojson')).toEqual(uses);
});

test('a dropped file becomes barriers, as one step of Undo', async ({ workbench: page, server }) => {
  await open(page, server);
  await drop(page, 'nets.geojson', nets);
  const dialog = page.getByRole('dialog', { name: 'What is nets.geojson?' });
  await dialog.getByRole('button', { name: '2 barriers' }).click();
  await expect(dialog).toHaveCount(0);
  const written = await projectText(page);
  expect(written).toMatch(/\[\[barrier\]\]\nname = "nets"\nline = \[\[26000\d\d\.?\d*, 12000\d\d\.?\d*\], \[26000\d\d\.?\d*, 1200\d+\.?\d*\]\]/);
  expect(written).toContain('name = "nets 2"');
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await projectText(page)).not.toContain('[[barrier]]');
});
