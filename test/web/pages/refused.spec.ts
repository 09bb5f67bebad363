// Rejected input: nothing is lost, and the reason is reported.

import { openForm, openProject } from '../support/steps';
import { expect, test } from '../support/workbench';

test('a project that is not UTF-8 is not opened or changed', async ({ workbench: page, server }) => {
  const latin = Buffer.from('# Gel\xe4nde am Fu\xdf der Wand\nname = "One"\n', 'latin1');
  server.write('latin.toml', latin);
  await page.reload();
  await page.getByRole('button', { name: /^latin\.toml/ }).click();
  await expect(page.getByText(/latin\.toml:1: cannot be shown as text.*Save it as UTF-8/)).toBeVisible();
  await expect(page.getByRole('heading', { level: 1, name: 'Talus' })).toBeVisible();
  expect(server.readBytes('latin.toml').equals(latin)).toBe(true);
});

test('replacing a file is confirmed before the upload', async ({ workbench: page, server }) => {
  const grid = 'ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n';
  server.write('dem.asc', 'old');
  await page.reload();
  const sent: string[] = [];
  page.on('request', (request) => request.method() === 'PUT' && sent.push(request.url().replace(/.*\//, '')));
  const pick = () =>
    page
      .getByLabel('Terrain file', { exact: true })
      .setInputFiles({ name: 'dem.asc', mimeType: 'text/plain', buffer: Buffer.from(grid) });
  const question = page.getByRole('dialog').filter({ hasText: 'dem.asc' });
  await pick();
  await expect(question).toBeVisible();
  expect(sent).toEqual([]);
  await pick(); // again, before the first question is answered
  await page.keyboard.press('Escape');
  await expect(question).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(question).toHaveCount(0);
  expect(server.read('dem.asc')).toBe('old');
  await pick();
  await question.getByRole('button', { name: /^Replace/ }).click();
  await expect(page.getByRole('navigation', { name: 'Model' })).toBeVisible();
  expect(server.read('dem.asc')).toBe(grid);
  expect(sent.filter((name) => name.startsWith('dem.asc'))).toEqual(['dem.asc?replace=1']);
});

test('an unreadable terrain is reported even in an incomplete project', async ({ workbench: page, server }) => {
  const good = '[terrain]\nsection = [[0, 10], [20, 0]]\nwidth_m = 10\n';
  server.write('good.toml', good);
  server.write('bad.asc', 'hello');
  await page.reload();
  await openProject(page, 'good.toml');
  await expect(page.getByText('There is no model to show yet.')).toHaveCount(0);
  await page.getByRole('tab', { name: 'Text' }).click();
  await page.getByLabel('Project file').fill('[terrain]\nraster = "bad.asc"\n');
  await expect(page.getByText('The terrain has errors. The last valid terrain is shown.')).toBeVisible();
  await page.getByRole('tab', { name: 'Model' }).click();
  await expect(page.locator('.problems')).toContainText('bad.asc');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByText('The terrain has errors')).toHaveCount(0);
  await expect(page.locator('.problems')).toHaveCount(0);
});

test('a material setting that is not a list is reported and not extended', async ({ workbench: page, server }) => {
  const odd = 'name = "odd"\nmaterial = 3\n';
  server.write('odd.toml', odd);
  await page.reload();
  await openProject(page, 'odd.toml');
  await expect(page.locator('.problems')).toContainText(/material/);
  await page.getByRole('button', { name: '+ Add material' }).click();
  await expect(
    page.getByText('Could not add a material: material already exists and is not a list of tables'),
  ).toBeVisible();
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('a file name that is too long is reported', async ({ workbench: page, server }) => {
  server.write('a.toml', 'name = "One"\n');
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Project and analysis/);
  await page.getByRole('button', { name: 'Save as…' }).click();
  await page.getByLabel('Name of the file in the folder').fill('x'.repeat(300));
  await page.keyboard.press('Enter');
  await expect(page.getByRole('dialog').getByRole('alert')).toContainText('(it is too long)');
});
