// The picture is of the terrain's file as it is, whoever changes it.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '../support/workbench';

/// A grid of text with all heights raised.
function raised(grid: string, by: number): string {
  const lines = grid.split('\n');
  const head = lines.findIndex((line) => /^\s*[\d.-]/.test(line));
  const up = (line: string) => line.trim().split(/\s+/).map((z) => (z === '' ? '' : (Number(z) + by).toFixed(1)));
  return lines.map((line, k) => (k < head ? line : up(line).join(' '))).join('\n');
}

test('changed on the disk, and dropped anew', async ({ workbench: page, server }) => {
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
  await page.getByRole('dialog').getByRole('button', { name: 'Replace it' }).click();
  await expect(legend).toContainText('294');
  await page.getByRole('tab', { name: 'Text' }).click();
  expect(await page.getByLabel('Project file').inputValue()).toContain(crs);
});
