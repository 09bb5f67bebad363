// Concurrent changes of a project by another tab, browser or program.

import type { BrowserContext, Page } from '@playwright/test';
import { backToModel, fillField, openForm, openProject, projectText, runCard } from '../support/steps';
import { expect, test, type Server } from '../support/workbench';

const one = 'name = "One"\n';
const rename = async (page: Page, name: string) => {
  await openForm(page, /^Project and analysis/);
  await fillField(page, 'Name', name);
};
const renameAndKeep = (page: Page, name: string) =>
  Promise.all([
    page.waitForResponse((response) => response.url().endsWith('/api/draft')),
    rename(page, name),
  ]);
const title = (page: Page, name: string) =>
  expect(page.getByRole('heading', { level: 1, name, exact: true })).toBeVisible();
const leave = (page: Page) => page.close({ runBeforeUnload: true });
const draft = (server: Server) => (server.has('.a.toml.draft') ? server.read('.a.toml.draft') : '');
const elsewhere = (page: Page) => page.getByText('This project is also being edited in another tab or browser.');

async function openIn(context: BrowserContext, address: string) {
  const page = await context.newPage();
  await page.goto(address);
  await openProject(page, 'a.toml');
  return page;
}

test('closing an older tab keeps the newer draft of another one', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  await renameAndKeep(page, 'Older');
  const second = await openIn(page.context(), `http://127.0.0.1:${server.port}/`);
  await title(second, 'Older');
  await renameAndKeep(second, 'Newer');
  await expect(elsewhere(page)).toBeVisible();
  await leave(second);
  await leave(page);
  await page.context().newPage().then((third) => third.goto(`http://127.0.0.1:${server.port}/`));
  expect(draft(server)).toContain('name = "Newer"');
});

test('no change of two tabs is lost', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  await renameAndKeep(page, 'Older');
  await backToModel(page);
  const second = await openIn(page.context(), `http://127.0.0.1:${server.port}/`);
  await renameAndKeep(second, 'Theirs');
  const [refused] = await renameAndKeep(page, 'Mine');
  expect(refused.status()).toBe(409);
  expect(draft(server)).toContain('name = "Theirs"');
  await page.reload();
  await title(page, 'Theirs');
  await expect(page.getByText('There is another draft of a, stored in this browser on')).toBeVisible();
  await page.getByRole('button', { name: 'Use the other draft' }).click();
  await title(page, 'Mine');
  await page.getByRole('button', { name: 'Undo' }).click();
  await title(page, 'Theirs');
  await page.getByRole('button', { name: 'Delete the other draft' }).click();
  await expect(page.getByText('There is another draft of a')).toHaveCount(0);
  await page.reload();
  await title(page, 'Theirs');
  await expect(page.getByText('There is another draft of a')).toHaveCount(0);
});

test('a local draft does not replace a newer one of another browser', async ({ workbench: page, server, browser }) => {
  server.write('a.toml', one);
  await page.reload();
  const address = await page.evaluate(async () => {
    const asked = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: '{}' };
    return ((await (await fetch('/api/tokens', asked)).json()) as { address: string }).address;
  });
  await openProject(page, 'a.toml');
  await openForm(page, /^Project and analysis/);
  await page.getByLabel('Name', { exact: true }).fill('Monday');
  await leave(page); // before the draft is sent: it is stored in the browser and sent on closing
  await expect.poll(() => draft(server)).toContain('Monday');

  const other = await browser.newContext();
  const tuesday = await openIn(other, address);
  await title(tuesday, 'Monday');
  await renameAndKeep(tuesday, 'Tuesday');
  await leave(tuesday);

  const again = await openIn(page.context(), `http://127.0.0.1:${server.port}/`);
  await title(again, 'Tuesday');
  await expect(again.getByText('There is another draft')).toHaveCount(0);
  await other.close();
});

const lookAgain = (page: Page) => page.evaluate(() => dispatchEvent(new Event('focus')));

test('an unchanged page reloads a file that another program changed', async ({ workbench: page, server }) => {
  const file = 'tutorial-1/tutorial-1-2d.toml';
  server.copyExample('tutorial-1');
  await page.reload();
  await openProject(page, file);
  server.write(file, server.read(file).replace('rocks = 50', 'rocks = 10'));
  await lookAgain(page);
  await expect(page.getByText(`Another program changed ${file}. It was reloaded.`)).toBeVisible();
  expect(await projectText(page)).toContain('rocks = 10');
  server.write(file, server.read(file).replace('rocks = 10', 'rocks = 11'));
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await page.getByRole('tab', { name: 'Runs' }).click();
  await expect(runCard(page, '11 rocks')).toBeVisible();

  await page.getByRole('tab', { name: 'Model' }).click();
  await renameAndKeep(page, 'Mine');
  server.write(file, server.read(file).replace('rocks = 11', 'rocks = 12'));
  await lookAgain(page);
  await expect(page.getByText('Another program has changed the file since.')).toBeVisible();
  await title(page, 'Mine');
  await page.getByRole('button', { name: 'Back to the file' }).click();
  expect(await projectText(page)).toContain('rocks = 12');
});

test('a deleted file can be saved again', async ({ workbench: page, server }) => {
  server.write('a.toml', one);
  await page.reload();
  await openProject(page, 'a.toml');
  server.removeFile('a.toml');
  await lookAgain(page);
  await expect(page.getByText('The file no longer exists. Saving creates it again.')).toBeVisible();
  await page.keyboard.press('Control+s');
  await expect(page.getByText('Saved a.toml')).toBeVisible();
  expect(server.read('a.toml')).toBe(one);
});
