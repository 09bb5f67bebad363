// A project from a GeoTIFF, with a drawn seeder, barrier and areas, and maps of results.

import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { backToModel, runIsShown } from '../support/steps';
import { expect, sources, test } from '../support/workbench';

/// Opens the valley of the example in a named view, given by its key.
async function openValley(page: Page, view: string) {
  await page.getByLabel('Terrain file').setInputFiles(join(sources, 'examples/first-gis-run/valley.tif'));
  await expect(page.getByText(/Elevation, m/)).toBeVisible({ timeout: 30_000 });
  await page.keyboard.press('Escape');
  const picture = page.getByRole('application', { name: /Model in three dimensions/ });
  await picture.focus();
  await picture.press(view);
  return picture;
}

test('a seeder and a barrier are drawn on a terrain file, and a map is draped over it', async ({ workbench: page, server }) => {
  test.setTimeout(120_000);
  const picture = await openValley(page, '1'); // oblique
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
  await page.getByRole('button', { name: 'rocks that were in the cell', exact: true }).click();
  await expect(page.locator('.legend').filter({ hasText: 'Rocks that were in the cell' })).toBeVisible();
});

test('areas of the ground are drawn, listed, undone, and marked if they are invalid', async ({ workbench: page, server }) => {
  const picture = await openValley(page, '2'); // plan
  for (const name of ['Rock', 'Scree']) {
    await page.getByRole('button', { name: '+ Add material' }).click();
    await page.getByLabel('Name', { exact: true }).fill(name);
    await page.getByLabel('Name', { exact: true }).press('Tab');
    await backToModel(page);
  }
  const outline = page.getByRole('navigation', { name: 'Model' });
  const box = (await picture.boundingBox())!;
  const draw = async (material: string, places: [number, number][]) => {
    await outline.getByRole('button', { name: /^Ground/ }).click();
    await page.getByRole('button', { name: `Draw an area of ${material}` }).click();
    for (const [x, y] of places) await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await page.keyboard.press('Enter');
    await expect(page.getByText(/overrides? the settings above\. Where/)).toBeVisible();
    await backToModel(page);
  };
  const built = page.waitForResponse(async (response) => {
    if (!response.url().endsWith('/api/model') || !response.ok()) return false;
    return (await response.json()).model?.areas.length === 2;
  });
  await draw('Scree', [[0.45, 0.4], [0.55, 0.4], [0.55, 0.6], [0.45, 0.6]]); // prettier-ignore
  await expect(page.getByRole('figure', { name: 'Material' })).toBeVisible(); // the view is coloured by material
  await draw('Rock', [[0.48, 0.45], [0.52, 0.45], [0.5, 0.55]]); // prettier-ignore
  await expect(outline.getByRole('button', { name: /^Area 1 Scree/ })).toBeVisible();
  await expect(outline.getByRole('button', { name: /^Area 2 Rock/ })).toBeVisible();
  const { areas, materials } = (await (await built).json()).model;
  expect(areas.map(({ material }: { material: number }) => materials[material])).toEqual(['Scree', 'Rock']);
  expect(areas[0].sides).toHaveLength(4);

  await outline.getByRole('button', { name: /^Area 1 Scree/ }).click();
  const table = page.getByRole('table', { name: 'Polygon' });
  await expect(table.getByRole('button', { name: /^Delete row/ })).toHaveCount(4);
  await page.getByRole('button', { name: 'Delete row 1', exact: true }).click();
  await page.getByRole('button', { name: 'Delete row 1', exact: true }).click();
  await expect(page.getByRole('group', { name: /^Polygon/ }).getByText(/three or more points/)).toBeVisible();
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(table.getByRole('button', { name: /^Delete row/ })).toHaveCount(4);
  await page.getByRole('combobox', { name: 'Material', exact: true }).selectOption('Rock');
  await backToModel(page);
  // Renaming a material updates its areas.
  await outline.getByRole('button', { name: /^Rock/ }).click();
  await page.getByLabel('Name', { exact: true }).fill('Limestone');
  await page.getByLabel('Name', { exact: true }).press('Tab');
  await backToModel(page);
  await expect(outline.getByRole('button', { name: /^Area 2 Limestone/ })).toBeVisible();
  await page.keyboard.press('Control+s');
  await expect(page.getByText(/^Saved/)).toBeVisible();
  expect(server.read('valley.toml').match(/\[\[area\]\]\nname = "Area \d"\nmaterial = "Limestone"\npolygon = \[\[/g)).toHaveLength(2);
});
