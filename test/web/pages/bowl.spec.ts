// Section 2.2 of the verification manual, built by hand: from an empty project to the trajectory of table 2-4.

import type { Page } from '@playwright/test';
import { shiftedText } from '../../../web/src/units/texts';
import { openForm } from '../support/steps';
import { cellsOf, printedUnit, published } from '../support/table';
import { expect, test } from '../support/workbench';

const [a, b, c, d] = [
  [-10, 10, 16.32993],
  [10, 10, 16.32993],
  [0, -7.32051, 16.32993],
  [0, 4.226497, 0],
] as const;

async function typePolyline(page: Page, vertices: readonly (readonly number[])[]) {
  const polyline = page.locator('details.polyline').last();
  for (const [k, vertex] of vertices.entries()) {
    await polyline.getByRole('button', { name: 'Insert row', exact: true }).click();
    for (const [axis, name] of ['x', 'y', 'z'].entries()) {
      const cell = page.locator('details.polyline').last().getByLabel(`${name}, row ${k + 1}`, { exact: true });
      await cell.fill(String(vertex[axis]));
      await cell.press('Tab');
    }
    // Three complete rows add the polyline to the project; the fourth is appended to it.
  }
}

async function pastePolyline(page: Page, vertices: readonly (readonly number[])[]) {
  await page.getByRole('button', { name: '+ Add polyline' }).click();
  await page.locator('details.polyline').last().getByRole('button', { name: 'Paste rows…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Paste rows' });
  await dialog.getByLabel('Rows').fill(vertices.map((vertex) => vertex.join('\t')).join('\n'));
  await dialog.getByRole('button', { name: 'Add the rows' }).click();
}

test('the bowl of the manual is built by hand, and its rock has the published trajectory', async ({ workbench: page, server }) => {
  await page.getByRole('textbox', { name: 'Name' }).fill('Bowl');
  await page.getByRole('button', { name: /Empty, 3D/ }).click();
  await page.getByRole('button', { name: /Closed polylines/ }).click();
  await typePolyline(page, [a, b, d, a]);
  await pastePolyline(page, [a, c, d, a]);
  await pastePolyline(page, [b, c, d, b]);
  await expect(page.getByRole('img', { name: 'Plan of 3 triangles' })).toBeVisible();
  await page.getByRole('button', { name: '‹ Model' }).click();
  // The published tables need the laws of RocFall.
  await openForm(page, /^Project and analysis/);
  await page.getByLabel('Laws', { exact: true }).selectOption('rocfall');
  await page.getByRole('button', { name: '‹ Model' }).click();

  await page.getByRole('button', { name: '+ Add material' }).click();
  await page.getByLabel('Normal restitution: mean').fill('0.3');
  await page.getByLabel('Tangential restitution: mean').fill('0.7');
  await page.getByLabel('Friction angle: mean').fill('30');
  await page.getByRole('button', { name: '‹ Model' }).click();

  await page.getByRole('button', { name: '+ Add seeder' }).click();
  const seeder = page.getByRole('region', { name: 'Seeder 1' });
  await seeder.getByLabel('Position, x').fill('0');
  await seeder.getByLabel('Position, y').fill('0');
  await seeder.getByLabel('Position, z').fill('20');
  await seeder.getByRole('textbox', { name: 'Rocks', exact: true }).fill('1');
  await seeder.getByRole('button', { name: 'Diameter', exact: true }).click();
  await seeder.getByLabel('Diameter: mean').fill('1');
  await seeder.getByLabel('Horizontal velocity: mean').fill('3');
  await seeder.getByLabel('Horizontal velocity: mean').press('Tab');
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await expect(page.getByText('Saved bowl.toml')).toBeVisible();
  expect(server.read('bowl.toml')).toContain('polylines = [');

  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await page.getByRole('tab', { name: 'Rock', exact: true }).click();
  await page.getByRole('spinbutton', { name: 'Rock' }).fill('0');
  await page.getByRole('spinbutton', { name: 'Rock' }).press('Enter');
  const table = page.getByRole('region', { name: 'Trajectory of rock 0' }).getByRole('table');
  await page.getByRole('checkbox', { name: 'All digits' }).check();
  const shown = await cellsOf(table);
  const head = await table.locator('thead th').allTextContents();
  const column = (name: string) => head.findIndex((text) => text.startsWith(name));

  const printed = published('2-bowl-lumped-mass/table-2-4.csv');
  const columns = {
    time_s: 'Time',
    x_m: 'x',
    y_m: 'y',
    z_m: 'z',
    vx_m_s: 'Velocity x',
    vy_m_s: 'Velocity y',
    vz_m_s: 'Velocity z',
    wx_rad_s: 'Spin x',
    wy_rad_s: 'Spin y',
    wz_rad_s: 'Spin z',
  };
  for (const [k, row] of printed.entries()) {
    for (const [name, title] of Object.entries(columns)) {
      const value = Number(shown[k]![column(title)]);
      expect(Math.abs(value - Number(row[name])), `row ${k}, ${name}`).toBeLessThanOrEqual(1.0001 * printedUnit(row[name]!));
    }
  }
  // All digits of the run's file; energies are shown in kJ.
  const runs = await page.evaluate(async () => (await fetch('/api/runs')).json());
  const [heading, ...lines] = server.read(`${runs.runs[0].folder}/paths.csv`).trim().split('\n');
  const names = heading!.trim().split(',').slice(1);
  const inShownUnit = (cell: string, k: number) => (names[k]!.endsWith('_J') ? shiftedText(cell, 3) : cell);
  const ofFile = lines.map((line: string) => line.trim().split(',').slice(1).map(inShownUnit));
  expect(shown).toEqual(ofFile);
});
