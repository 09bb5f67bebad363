// A GeoTIFF, a seeder drawn as a polygon, a barrier, a map.

import { join } from 'node:path';
import { backToModel, runIsShown } from '../support/steps';
import { expect, sources, test } from '../support/workbench';

test('a terrain file is taken, a polygon and a barrier are drawn, and a map lies on the ground', async ({ workbench: page, server }) => {
  test.setTimeout(120_000);
  await page.getByLabel('Terrain file').setInputFiles(join(sources, 'examples/first-gis-run/valley.tif'));
  await expect(page.getByText(/Elevation, m/)).toBeVisible({ timeout: 30_000 });
  await page.keyboard.press('Escape');
  const picture = page.getByRole('application', { name: /Model in three dimensions/ });
  await picture.focus();
  await picture.press('1'); // from above
  await page.getByRole('button', { name: '+ Add material' }).click();
  await backToModel(page);

  await page.getByRole('button', { name: '+ Add seeder' }).click();
  await page.getByLabel('Type', { exact: true }).selectOption('polygon');
  await page.getByRole('button', { name: /^Draw/ }).first().click();
  const box = (await picture.boundingBox())!;
  const at = (x: number, y: number) => page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  await at(0.45, 0.4);
  await at(0.55, 0.4);
  await at(0.55, 0.55);
  await at(0.45, 0.55);
  await page.getByRole('button', { name: 'Finish' }).click();
  await page.getByRole('textbox', { name: 'Rocks', exact: true }).fill('200');
  await page.getByLabel('Mass: mean').fill('500');
  await page.getByLabel('Mass: mean').press('Tab');
  await backToModel(page);

  await page.getByRole('button', { name: '+ Add barrier' }).click();
  await page.getByRole('button', { name: /^Draw/ }).first().click();
  await at(0.35, 0.7);
  await at(0.65, 0.7);
  await page.getByRole('button', { name: 'Finish' }).click();
  await page.getByLabel(/^Capacity/).fill('1000');
  await page.getByLabel(/^Capacity/).press('Tab');

  await page.keyboard.press('Control+s');
  await expect(page.getByText(/^Saved/)).toBeVisible();
  const project = server.read('valley.toml');
  expect(project).toContain('raster = "valley.tif"');
  expect(project).toMatch(/polygon = \[/);
  expect(project).toMatch(/line = \[\[/);

  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await runIsShown(page);
  await page.getByRole('tab', { name: 'Maps' }).click();
  await page.getByRole('button', { name: 'passages' }).click();
  await expect(page.locator('.legend').filter({ hasText: 'passages' })).toBeVisible();
});
