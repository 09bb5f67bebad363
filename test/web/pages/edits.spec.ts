// Changes apply to the right entry, or are rejected with a reason.

import { backToModel, fillField, openExample, openForm, openProject, projectText, toStartPage } from '../support/steps';
import { expect, test } from '../support/workbench';

test('correcting a duplicate name keeps the materials of the ground', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const ground = (text: string) => /\[ground\][^[]*\[[^\]]*\]/.exec(text)![0];
  const before = ground(await projectText(page));
  await openForm(page, /^Type Two/);
  await fillField(page, 'Name', 'Type One');
  await expect(page.locator('.side .problem').filter({ visible: true }).first()).toBeVisible();
  await fillField(page, 'Name', 'Type 2');
  expect(ground(await projectText(page))).toBe(before.replace('Type Two', 'Type 2'));
});

const twoTriangles = `name = "Two triangles"
[terrain]
vertices = [[0, 0, 0], [10, 0, 0], [10, 10, -5], [0, 10, -5]]
triangles = [[0, 1, 2], [0, 2, 3]]
[ground]
triangles = [1, 0]
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[[seeder]]
name = "Left"
position = [2, 1, 1]
rocks = 1
mass_kg = 100
[[seeder]]
name = "Right"
position = [8, 1, 1]
rocks = 1
mass_kg = 100
`;

test('deleting a material unassigns its triangles and reports it', async ({ workbench: page, server }) => {
  server.write('a.toml', twoTriangles);
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Soil/);
  await page.getByRole('button', { name: 'Delete material' }).click();
  await expect(page.getByText(/triangles.* is -1/)).toBeVisible();
  await expect(page.getByRole('button', { name: 'Compute', exact: true })).toBeDisabled();
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await projectText(page)).toBe(twoTriangles);
});

test('a direction is a word or numbers', async ({ workbench: page, server }) => {
  server.write('a.toml', twoTriangles);
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Right/);
  const way = page.getByLabel('Direction, how it is given');
  await way.selectOption('downslope');
  await expect(page.getByLabel('Direction, x')).toHaveCount(0);
  expect(await projectText(page)).toBe(`${twoTriangles}direction = "downslope"\n`);
  await way.selectOption('as numbers');
  await expect(page.getByLabel('Direction, x')).toBeVisible();
  expect(await projectText(page)).toBe(twoTriangles);
});

test('a drawing ends when its project or entry is closed or deleted', async ({ workbench: page, server }) => {
  server.write('a.toml', twoTriangles);
  server.write('b.toml', twoTriangles);
  await page.reload();
  await openProject(page, 'a.toml');
  const hint = page.getByText('Click where rocks start.');
  const pick = page.getByRole('button', { name: 'Pick in the view' });

  await openForm(page, /^Right/);
  await pick.click();
  await expect(hint).toBeVisible();
  await toStartPage(page);
  await openProject(page, 'b.toml');
  await expect(hint).toHaveCount(0);

  // The entry is deleted, or its index changes by Undo.
  await openForm(page, /^Right/);
  await pick.click();
  await page.getByRole('button', { name: 'Delete seeder' }).click();
  await expect(hint).toHaveCount(0);
  await openForm(page, /^Left/);
  await pick.click();
  await expect(hint).toBeVisible();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(hint).toHaveCount(0);
  expect(await projectText(page)).toBe(twoTriangles);
});

test('forms report that they cannot change a text that is not valid TOML', async ({ workbench: page, server }) => {
  server.write('a.toml', twoTriangles);
  server.write('b.toml', '[[broken\n');
  await page.reload();
  await openProject(page, 'a.toml');
  await page.getByRole('tab', { name: 'Text' }).click();
  await page.getByLabel('Project file').fill(`${twoTriangles}[[broken`);
  await page.getByRole('tab', { name: 'Model' }).click();
  await openForm(page, /^Project and analysis/);
  await fillField(page, 'Name', 'Lost');
  await expect(page.getByText(/^Could not change Name of the project: the text is not valid TOML \(line 21/)).toBeVisible();
  await expect(page.getByLabel('Name', { exact: true })).toHaveValue('Two triangles');
  await toStartPage(page);
  // The next project does not show its values.
  await openProject(page, 'b.toml');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('b');
  await expect(page.getByRole('navigation', { name: 'Model' }).getByRole('button', { name: /^Rock/ })).toHaveCount(0);
});

test('a file with a byte order mark is shown and edited', async ({ workbench: page, server }) => {
  server.write('a.toml', `\ufeff${twoTriangles}`);
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Project and analysis/);
  await fillField(page, 'Name', 'Three');
  await page.keyboard.press('Control+s');
  await expect(page.getByText('Saved a.toml')).toBeVisible();
  expect(server.read('a.toml')).toBe(`\ufeff${twoTriangles.replace('Two triangles', 'Three')}`);
});

test('Undo stops at saved states and handles each cell as one step', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Crest/);
  await fillField(page, 'Rocks', '100');
  await page.keyboard.press('Control+s');
  await fillField(page, 'Rocks', '200');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByLabel('Rocks', { exact: true })).toHaveValue('100');
  await backToModel(page);

  await openForm(page, /^Terrain/);
  await fillField(page, 'x, row 2', '3.3');
  await page.getByLabel('Insert a row above row 3').click();
  await fillField(page, 'x, row 3', '5');
  await fillField(page, 'z, row 3', '-12.3');
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await projectText(page)).toContain('[[0, 0], [3.3, -12.2], [6.7, -12.2]');
});
