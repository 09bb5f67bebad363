// Sections from files that are dropped on the page or imported.

import type { Page } from '@playwright/test';
import { openProject, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

/// Drops a file on the page.
const drop = (page: Page, name: string, text: string) =>
  page.evaluate(
    ([called, content]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content!], called!));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, text],
  );
const question = (page: Page, name: string) => page.getByRole('dialog', { name: `What is ${name}?` });
const titles = (page: Page, name: string) => question(page, name).locator('.drop-uses span:first-child').allTextContents();

const before = '[terrain]\nsection = [[0, 9], [9, 0]]\nsection_std_dev_m = [[0, 0], [0, 0.1]]\n';

test('a dropped profile becomes the section, as one step of Undo; feet are refused', async ({ workbench: page, server }) => {
  server.write('slope.toml', before);
  await page.reload();
  await openProject(page, 'slope.toml');

  await drop(page, 'feet.csv', 'x_ft,z_ft\n0,90\n40,0\n');
  await expect(question(page, 'feet.csv').locator('.problem')).toHaveText(/^feet\.csv:1: column "x_ft" is in feet .*Convert it to metres/);
  expect(await titles(page, 'feet.csv')).toEqual(['Only store it']);
  await question(page, 'feet.csv').getByRole('button', { name: 'Close' }).click();
  expect(await projectText(page)).toBe(before);

  await drop(page, 'profile.csv', 'distance_m,z_m\n0,30\n10,20\n20,12\n40,0\n');
  const drawn = page.waitForResponse((response) => response.url().endsWith('/profile'));
  await question(page, 'profile.csv').getByRole('button', { name: 'Section (2D)' }).click();
  expect((await (await drawn).json()).vertices).toEqual([[0, 30], [10, 20], [20, 12], [40, 0]]); // prettier-ignore
  expect(await projectText(page)).toBe('[terrain]\nsection = "profile.csv"\n');
  expect(server.read('profile.csv')).toContain('10,20\n');
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await projectText(page)).toBe(before);
});

test('points in space can be a section or a survey, a line only a section', async ({ workbench: page }) => {
  await page.getByLabel('Terrain file', { exact: true }).setInputFiles({
    name: 'line.csv', mimeType: 'text/csv', buffer: Buffer.from('x,y,z\n0,0,30\n10,4,20\n20,0,12\n40,4,0\n'),
  }); // prettier-ignore
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('line');
  await expect.poll(() => titles(page, 'line.csv')).toEqual(['Section (2D)', 'Survey (3D)', 'Only store it']);
  await question(page, 'line.csv').getByRole('button', { name: 'Section (2D)' }).click();
  expect(await projectText(page)).toContain('section = "line.csv"');

  const rows = [0, 10, 20, 30].flatMap((y) => [0, 10, 20, 30].map((x) => `${x} ${y} ${x + y}`)).join('\n');
  await drop(page, 'grid.xyz', rows);
  await expect.poll(() => titles(page, 'grid.xyz')).toEqual(['Survey (3D)', 'Section (2D)', 'Only store it']);
  await question(page, 'grid.xyz').getByRole('button', { name: 'Close' }).click();

  const coordinates = [[0, 0, 30], [10, 0, 20], [40, 0, 0]]; // prettier-ignore
  const line = JSON.stringify({ type: 'LineString', crs: { type: 'name', properties: { name: 'EPSG:31287' } }, coordinates });
  await drop(page, 'line.geojson', line);
  await expect.poll(() => titles(page, 'line.geojson')).toEqual(['Section (2D)', 'Only store it']);
});
