// The cards of the start page: pictures, order, search, and what can be done with a project.

import type { Page } from '@playwright/test';
import { backToModel, fillField, openExample, openForm, runCard, toStartPage } from '../support/steps';
import { expect, test } from '../support/workbench';

const list = (page: Page) => page.getByRole('region', { name: 'Projects in this folder' });
const cards = (page: Page) => list(page).locator('.project-card');
const names = (page: Page) => cards(page).locator('.name').allTextContents();

async function choose(page: Page, file: string, action: string) {
  await list(page).getByLabel(`Rename, duplicate or delete ${file}`).click();
  await list(page).getByRole('button', { name: action }).click();
  return page.getByRole('dialog');
}

/// Whether the picture of a card is loaded, and the number of its colours.
async function coloursOf(page: Page, file: string): Promise<number> {
  const picture = cards(page).filter({ hasText: file }).locator('img');
  await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.complete && image.naturalWidth)).toBeGreaterThan(400);
  return picture.evaluate((image: HTMLImageElement) => {
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width: image.naturalWidth, height: image.naturalHeight });
    const pen = canvas.getContext('2d')!;
    pen.drawImage(image, 0, 0);
    const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
    const seen = new Set<number>();
    for (let k = 0; k < data.length; k += 4) seen.add(((data[k]! >> 4) << 8) | ((data[k + 1]! >> 4) << 4) | (data[k + 2]! >> 4));
    return seen.size;
  });
}

test('every example has a picture', async ({ workbench: page }) => {
  const pictures = page.getByRole('region', { name: 'Try an example' }).locator('img');
  await expect(pictures).toHaveCount(11);
  for (const picture of await pictures.all()) {
    await picture.scrollIntoViewIfNeeded();
    await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(400);
  }
});

test('a project that was seen has a picture, in 2D and in 3D', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await toStartPage(page);
  expect(await coloursOf(page, 'tutorial-1-2d.toml')).toBeGreaterThan(20);
  await expect(cards(page).first()).toContainText('Done, 50 rocks · 1 run');
  await openExample(page, 'Tutorial 1, in 3D');
  await expect.poll(async () => (await page.locator('.scene canvas').first().screenshot()).length).toBeGreaterThan(20_000);
  await toStartPage(page);
  expect(await coloursOf(page, 'tutorial-1-3d.toml')).toBeGreaterThan(20);
  await expect.poll(() => names(page)).toEqual(['tutorial-1/tutorial-1-3d.toml', 'tutorial-1/tutorial-1-2d.toml']);
});

test('a project is renamed with its runs', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await toStartPage(page);
  const dialog = await choose(page, 'tutorial-1/tutorial-1-2d.toml', 'Rename…');
  await expect(dialog).toContainText('It keeps its 1 run.');
  const field = dialog.getByLabel('Name of the file');
  await field.fill('a/b');
  await dialog.getByRole('button', { name: 'Rename' }).click();
  await expect(dialog.getByRole('alert')).toContainText('a/b.toml: is not the name of a file');
  await field.fill('Above the road');
  await dialog.getByRole('button', { name: 'Rename' }).click();
  await expect(dialog).toHaveCount(0);
  expect((await names(page)).sort()).toEqual(['tutorial-1/Above the road.toml', 'tutorial-1/tutorial-1-3d.toml']);
  expect(server.has('tutorial-1/tutorial-1-2d.toml')).toBe(false);
  expect(await coloursOf(page, 'Above the road.toml')).toBeGreaterThan(20);

  await cards(page).filter({ hasText: 'Above the road.toml' }).getByRole('button').first().click();
  await page.getByRole('tab', { name: 'Runs' }).click();
  await expect(runCard(page, 'Tutorial 1, section')).toContainText('Done');
  await expect(page.getByRole('group', { name: 'Playback' })).toBeVisible();
});

test('a project is duplicated with its comments and another title', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await page.reload();
  const dialog = await choose(page, 'tutorial-1/tutorial-1-2d.toml', 'Duplicate…');
  await expect(dialog.getByLabel('Name of the file')).toHaveValue('tutorial-1-2d copy.toml');
  await dialog.getByRole('button', { name: 'Duplicate' }).click();
  await expect(cards(page)).toHaveCount(3);
  const [original, copy] = [server.read('tutorial-1/tutorial-1-2d.toml'), server.read('tutorial-1/tutorial-1-2d copy.toml')];
  expect(copy).toBe(original.replace('name = "Tutorial 1, section"', 'name = "Tutorial 1, section (copy)"'));
  expect(copy).not.toBe(original);
});

test('a project is deleted, restored, and deleted for good', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await toStartPage(page);
  const file = 'tutorial-1/tutorial-1-2d.toml';
  const remove = async () => {
    const dialog = await choose(page, file, 'Delete…');
    await expect(dialog).toContainText('The project, its 1 run and its picture are moved to Deleted projects');
    await dialog.getByRole('button', { name: 'Delete', exact: true }).click();
    await expect(dialog).toHaveCount(0);
  };
  await remove();
  await expect(cards(page).filter({ hasText: '-2d.toml' })).toHaveCount(0);
  expect(server.has(file)).toBe(false);
  await page.getByText('Deleted projects (1)').click();
  await page.getByRole('button', { name: `Restore ${file}` }).click();
  await expect(cards(page).filter({ hasText: '-2d.toml' })).toContainText('Done, 50 rocks · 1 run');
  expect(server.has(file)).toBe(true);
  await remove();
  await page.getByText('Deleted projects (1)').click();
  await page.getByRole('button', { name: `Delete ${file} for good` }).click();
  await expect(page.getByText(/^Deleted projects/)).toHaveCount(0);
  expect(server.has('.talus-deleted')).toBe(false);
});

test('a project with a run under way is neither renamed nor deleted', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Crest/);
  await fillField(page, 'Rocks', '50000000');
  await backToModel(page);
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(page.getByRole('button', { name: 'Stop' }).first()).toBeVisible();
  await toStartPage(page);
  const file = 'tutorial-1/tutorial-1-2d.toml';
  for (const [action, verb, word] of [['Rename…', 'Rename', 'renamed'], ['Delete…', 'Delete', 'deleted']] as const) {
    const dialog = await choose(page, file, action);
    if (action === 'Rename…') await dialog.getByLabel('Name of the file').fill('other.toml');
    await dialog.getByRole('button', { name: verb, exact: true }).click();
    await expect(dialog.getByRole('alert')).toContainText(`${file}: cannot be ${word} (its run "Tutorial 1, section" is running). Stop it first`);
    await dialog.getByRole('button', { name: 'Close' }).click();
  }
  expect(server.has(file)).toBe(true);
});

test('many projects are listed by time and can be searched', async ({ workbench: page, server }) => {
  for (let k = 0; k < 7; ++k) server.write(`slope ${k}.toml`, `name = "s"`);
  server.touch('slope 3.toml', 60);
  server.touch('slope 5.toml', 30);
  await page.reload();
  await expect(cards(page)).toHaveCount(7);
  expect((await names(page)).slice(0, 2)).toEqual(['slope 3.toml', 'slope 5.toml']);
  await page.getByRole('searchbox', { name: 'Search projects' }).fill('SLOPE 6');
  expect(await names(page)).toEqual(['slope 6.toml']);
  await page.getByRole('searchbox', { name: 'Search projects' }).fill('none');
  await expect(list(page)).toContainText('No project has “none” in its name.');
});
