// The view follows changes of the terrain's file.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '../support/workbench';

/// An ASCII grid with all heights raised.
function raised(grid: string, by: number): string {
  const lines = grid.split('\n');
  const head = lines.findIndex((line) => /^\s*[\d.-]/.test(line));
  const up = (line: string) => line.trim().split(/\s+/).map((z) => (z === '' ? '' : (Number(z) + by).toFixed(1)));
  return lines.map((line, k) => (k < head ? line : up(line).join(' '))).join('\n');
}

test('the terrain is reloaded when its file changes on disk or is dropped again', async ({ workbench: page, server }) => {
  server.copyExample('maungawhau');
  const grid = server.read('maungawhau/maungawhau.asc');
  const crs = /\ncrs = .*\n/.exec(server.read('maungawhau/maungawhau.toml'))![0].trim();
  await page.reload();
  await page.getByRole('button', { name: /maungawhau\/maungawhau\.toml/ }).first().click();
  const legend = page.getByRole('figure', { name: 'Elevation, m' });
  await expect(legend).toContainText('94');

  writeFileSync(join(server.folder, 'maungawhau/maungawhau.asc'), raised(grid, 100));
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(legend).toContainText('194');

  writeFileSync(join(server.folder, 'maungawhau/maungawhau.asc'), raised(grid, 300));
  await page.evaluate(() => dispatchEvent(new Event('focus')));
  await expect(legend).toContainText('394');

  await page.evaluate((text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], 'maungawhau.asc'));
    dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, raised(grid, 200));
  await page.getByRole('dialog').getByRole('button', { name: 'Replace the file' }).click();
  await expect(legend).toContainText('294');
  await page.getByRole('tab', { name: 'Text' }).click();
  expect(await page.getByLabel('Project file').inputValue()).toContain(crs);
});

test('a file that changes while the model is built is noticed', async ({ workbench: page, server }) => {
  server.copyExample('maungawhau');
  const grid = server.read('maungawhau/maungawhau.asc');
  await page.reload();
  await page.getByRole('button', { name: /maungawhau\/maungawhau\.toml/ }).first().click();
  const legend = page.getByRole('figure', { name: 'Elevation, m' });
  await expect(legend).toContainText('94');

  // The answer about the file as it was is held back until the file has changed and the page has the focus again.
  let giveAnswer = () => {};
  const changed = new Promise<void>((resolve) => (giveAnswer = resolve));
  const answered = new Promise<void>((resolve) => {
    void page.route('**/api/model', async (route) => {
      const response = await route.fetch();
      resolve();
      await changed;
      await route.fulfill({ response });
    }, { times: 1 });
  });
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await answered;
  writeFileSync(join(server.folder, 'maungawhau/maungawhau.asc'), raised(grid, 100));
  await page.evaluate(() => dispatchEvent(new Event('focus')));
  giveAnswer();
  await expect(legend).toContainText('194');
});
