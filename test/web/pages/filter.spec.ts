// The rock filter applies to the view, its legends and the tables of its project.

import type { Page } from '@playwright/test';
import { rowsOf } from '../support/table';
import { stillShot, viewShot } from '../support/pixels';
import { openExample, toStartPage } from '../support/steps';
import { expect, test, type Server } from '../support/workbench';

const panel = (page: Page, name: string) => page.locator('summary').filter({ hasText: name });
const tick = async (page: Page, name: string, box: string, isOn: boolean) => {
  await panel(page, name).click();
  await page.getByRole('checkbox', { name: box, exact: true }).setChecked(isOn);
  await page.keyboard.press('Escape');
};
async function filterByEnergy(page: Page, least: string) {
  await panel(page, 'Filter').click();
  await page.getByLabel('At least').fill(least);
  await page.getByLabel('At least').press('Tab');
  await page.keyboard.press('Escape');
}

async function folderOf(page: Page): Promise<string> {
  const { runs } = await page.evaluate(async () => (await fetch('/api/runs')).json());
  return runs[0].folder;
}
const endsOf = (server: Server, folder: string) => rowsOf(server.read(`${folder}/endpoints.csv`));

test('a filter that no rock passes hides all trajectories and end points in 3D', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await tick(page, 'Layers', 'Trajectories', false);
  await tick(page, 'Layers', 'End points', false);
  await page.mouse.move(0, 0);
  const bare = await stillShot(page);
  await tick(page, 'Layers', 'Trajectories', true);
  await tick(page, 'Layers', 'End points', true);
  await page.mouse.move(0, 0);
  await expect.poll(async () => (await viewShot(page)).equals(bare)).toBe(false);
  const full = await stillShot(page);
  await filterByEnergy(page, '1000000');
  await page.mouse.move(0, 0);
  await expect(page.getByText('0 of 50 trajectories')).toBeVisible();
  await expect.poll(async () => (await viewShot(page)).equals(bare)).toBe(true);
  await filterByEnergy(page, '');
  await page.mouse.move(0, 0);
  await expect.poll(async () => (await viewShot(page)).equals(full)).toBe(true);
});

test('the overview is of the filtered rocks and shows their number', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  const ends = endsOf(server, await folderOf(page));
  const energies = ends.map(({ max_ke_J }) => Number(max_ke_J)).sort((a, b) => a - b);
  const least = Math.ceil(energies[30]! / 1000);
  const left = ends.filter(({ max_ke_J }) => Number(max_ke_J) >= 1000 * least);
  await filterByEnergy(page, String(least));
  await page.getByRole('tab', { name: 'Overview' }).click();
  const population = `${left.length} of 50 rocks`;
  const table = page.getByRole('region', { name: `Statistics over ${population}` });
  await expect(table).toBeVisible();
  await expect(page.locator('.filter-note')).toContainText(population);
  await page.getByRole('checkbox', { name: 'All digits' }).check();
  const smallest = Math.min(...left.map(({ max_ke_J }) => Number(max_ke_J)));
  const cells = await table.getByRole('row', { name: /^Minimum/ }).locator('td').allTextContents();
  const column = (await table.getByRole('columnheader').allTextContents()).findIndex((text) => /kinetic/.test(text));
  expect(Math.abs(Number(cells[column - 1]) * 1000 - smallest)).toBeLessThan(1e-9 * smallest);
  const counted = page.getByRole('region', { name: 'End reasons' }).locator('tbody td');
  const total = (await counted.allTextContents()).reduce((sum, text) => sum + Number(text), 0);
  expect(total).toBe(left.length);
});

test('display settings belong to a project', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await tick(page, 'Trajectories', 'Show trajectories', false);
  await filterByEnergy(page, '1000000');
  await toStartPage(page);
  await openExample(page, 'Tutorial 1, a section');
  await expect(panel(page, 'Filter')).toHaveText(/^Filter\s*▾$/);
  await panel(page, 'Trajectories').click();
  await expect(page.getByRole('checkbox', { name: 'Show trajectories' })).toBeChecked();
  await page.keyboard.press('Escape');
  await expect(page.getByText('Speed, m/s')).toBeVisible();
  // The first project keeps its settings, but not the filter, which is easily forgotten.
  await toStartPage(page);
  await openExample(page, 'Tutorial 1, in 3D');
  await panel(page, 'Trajectories').click();
  await expect(page.getByRole('checkbox', { name: 'Show trajectories' })).not.toBeChecked();
  await expect(panel(page, 'Filter')).toHaveText(/^Filter\s*▾$/);
});

test('moving rocks are shown without trajectories', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await tick(page, 'Layers', 'Trajectories', false);
  await page.getByRole('slider', { name: 'Time' }).press('PageDown');
  await page.mouse.move(0, 0);
  const one = await stillShot(page);
  await page.getByRole('slider', { name: 'Time' }).press('PageDown');
  await expect.poll(async () => (await viewShot(page)).equals(one)).toBe(false);
});
