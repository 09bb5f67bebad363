// Unsaved changes are never lost and files never overwritten unasked: by a reload, a killed server, another tab, folder or
// program.

import type { Page } from '@playwright/test';
import { backToModel, fillField, openExample, openForm, openProject, toStartPage } from '../support/steps';
import { expect, Server, test } from '../support/workbench';

const roughness = 'Roughness: mean';

test('a reload keeps unsaved changes', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  const saved = server.read('tutorial-1/tutorial-1-2d.toml');
  await openForm(page, /^Type Two/);
  await page.getByLabel(roughness).fill('2.5');
  await page.getByLabel(roughness).press('Tab');
  await page.reload(); // the form stays open
  await expect(page.getByLabel(roughness)).toHaveValue('2.5');
  expect(server.read('tutorial-1/tutorial-1-2d.toml')).toBe(saved);
  // Undo returns to the saved file.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByLabel(roughness)).toHaveValue('');
});

test('saving keeps comments and order of unchanged parts', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  const before = server.read('tutorial-1/tutorial-1-2d.toml');
  await openForm(page, /^Type Two/);
  await page.getByLabel('Normal restitution: mean').fill('0.41');
  await page.getByLabel('Normal restitution: mean').press('Tab');
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await expect(page.getByText(/^Saved/)).toBeVisible();
  const after = server.read('tutorial-1/tutorial-1-2d.toml');
  expect(after).toContain('mean = 0.41');
  expect(after.replace('mean = 0.41', 'mean = 0.4')).toBe(before);
});

test('the page, the draft and the run survive a killed and restarted server', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type Two/);
  await page.getByLabel(roughness).fill('1.5');
  await page.getByLabel(roughness).press('Tab');
  await page.waitForResponse((response) => response.url().endsWith('/api/draft'));
  await server.end('SIGKILL');
  await expect(page.getByRole('alert').filter({ hasText: 'The server does not respond' })).toBeVisible({ timeout: 30_000 });
  await page.getByLabel(roughness).fill('1.75');
  await page.getByLabel(roughness).press('Tab');
  await server.startFor(page);
  await expect(page.getByRole('alert').filter({ hasText: 'The server does not respond' })).toBeHidden({ timeout: 30_000 });
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await expect(page.getByText(/^Saved/)).toBeVisible();
  expect(server.read('tutorial-1/tutorial-1-2d.toml')).toContain('1.75');
  await page.getByRole('tab', { name: 'Runs' }).click();
  await expect(page.locator('li.run')).toContainText('Done');
});

const one = 'name = "One"\n';
const rename = async (page: Page, name: string) => {
  await openForm(page, /^Project and analysis/);
  await fillField(page, 'Name', name);
};
const title = (page: Page, name: string) =>
  expect(page.getByRole('heading', { level: 1, name, exact: true })).toBeVisible();
const drafted = (page: Page) =>
  page.waitForResponse((response) => response.url().endsWith('/api/draft') && response.ok());

test('a draft does not overwrite a file that changed since', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  const kept = drafted(page);
  await rename(page, 'Mine');
  await kept;
  server.write('a.toml', 'name = "Theirs"\n');
  await page.reload();
  await title(page, 'Mine');
  await expect(page.getByText(/Another program has changed the file since/)).toBeVisible();
  await page.getByRole('button', { name: 'Keep the draft' }).click();
  await page.keyboard.press('Control+s');
  const dialog = page.getByRole('dialog', { name: 'Not saved' });
  await expect(dialog).toContainText('was changed by another program meanwhile');
  expect(server.read('a.toml')).toBe('name = "Theirs"\n');
  await dialog.getByRole('button', { name: 'Overwrite the file' }).click();
  await expect(page.getByText('Saved a.toml')).toBeVisible();
  expect(server.read('a.toml')).toBe('name = "Mine"\n');
});

test('repeated saving stores the last text without conflicts', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Project and analysis/);
  await page.route(/\/api\/project$/, async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 100));
    await route.continue();
  });
  for (const name of ['Two', 'Three', 'Four']) {
    await page.getByLabel('Name', { exact: true }).fill(name);
    await page.keyboard.press('Control+s');
    await page.keyboard.press('Control+s');
  }
  await expect(page.getByRole('button', { name: 'Save', exact: true })).toBeDisabled();
  await expect(page.getByRole('dialog')).toHaveCount(0);
  expect(server.read('a.toml')).toBe('name = "Four"\n');
});

test('typed text survives a visit to the start page and a reload', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Project and analysis/);
  await page.getByLabel('Name', { exact: true }).fill('Two');
  await toStartPage(page);
  await expect(page.getByRole('button', { name: 'a.toml' })).toContainText('with an unsaved draft');
  await openProject(page, 'a.toml');
  await title(page, 'Two');
  await openForm(page, /^Project and analysis/);
  await page.getByLabel('Name', { exact: true }).fill('Three');
  await page.reload();
  await title(page, 'Three');
});

test('after a reload, Undo does not empty a project that was never saved', async ({ workbench: page }) => {
  await page.getByRole('button', { name: 'Empty, 3D' }).click();
  await backToModel(page);
  const kept = drafted(page);
  await rename(page, 'First');
  await kept;
  await page.reload();
  await title(page, 'First');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await fillField(page, 'Name', 'Second');
  await page.getByRole('button', { name: 'Undo' }).click();
  await title(page, 'First');
});

test('a new project does not replace one that was never saved', async ({ workbench: page }) => {
  const begin = () => page.getByRole('button', { name: 'Empty, 3D' }).click();
  await begin();
  await backToModel(page);
  await rename(page, 'First');
  await toStartPage(page);
  await begin();
  await title(page, 'New slope');
  await toStartPage(page);
  await expect(page.getByRole('button', { name: 'new-slope-2.toml' })).toBeVisible();
  await openProject(page, 'new-slope.toml');
  await title(page, 'First');
});

test('a draft stays with its folder when another folder is served on the same port', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Project and analysis/);
  await expect(page.getByLabel('Name', { exact: true })).toBeVisible();
  await server.end('SIGKILL');
  await fillField(page, 'Name', 'Mine');
  await expect.poll(() => page.evaluate(() => Object.values(localStorage).join())).toContain('Mine');

  const other = new Server(server.port);
  other.write('a.toml', one);
  // The open page writes nothing into the other folder.
  await other.start();
  await page.context().newPage().then((entering) => entering.goto(other.address));
  await page.keyboard.press('Control+s');
  await expect(page.getByText(/a\.toml: belongs to another folder/)).toBeVisible();
  expect(other.read('a.toml')).toBe(one);
  // The project of the same address there has no draft.
  await page.reload();
  await title(page, 'One');
  await other.remove();

  await server.start();
  await page.goto(server.address);
  await title(page, 'Mine');
});

test('a tab that returns to the file keeps the draft of another tab', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  const kept = drafted(page);
  await rename(page, 'Mine');
  await kept;
  const second = await page.context().newPage();
  await second.goto(`http://127.0.0.1:${server.port}/`);
  await openProject(second, 'a.toml');
  await title(second, 'Mine');
  const [again] = await Promise.all([
    page.waitForRequest((request) => request.url().endsWith('/api/draft')),
    second.getByRole('button', { name: 'Back to the file' }).click(),
  ]);
  expect((await again.response())!.ok()).toBe(true);
  await title(second, 'One');
  expect(server.read('.a.toml.draft')).toContain('name = "Mine"');
});
