import { expect, test } from '../support/workbench';

test('the address works once and leads to the start page', async ({ workbench, server, browser }) => {
  await expect(workbench.getByRole('heading', { name: 'Talus' })).toBeVisible();
  expect(workbench.url()).toBe(`http://127.0.0.1:${server.port}/`);

  const other = await browser.newContext();
  const page = await other.newPage();
  const answer = await page.goto(server.address);
  expect(answer?.status()).toBe(403);
  await expect(page.getByRole('heading', { name: 'This address has been used' })).toBeVisible();
  await other.close();
});

test('a click opens an example and copies its files to the folder', async ({ workbench, server }) => {
  await workbench.getByRole('button', { name: /Tutorial 1, a section/ }).click();
  await expect(workbench.getByRole('button', { name: 'Compute' })).toBeVisible();
  expect(server.read('tutorial-1/tutorial-1-2d.toml')).toContain('Tutorial 1 of RocFall2');
});
