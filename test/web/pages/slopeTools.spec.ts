// Slope tools in section: a ditch by dragging and by numbers, its retained share, and what stays in it.

import type { Page } from '@playwright/test';
import { drag, pixelOf } from '../support/places';
import { openExample, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

const card = (page: Page) => page.getByRole('region', { name: 'Slope tools' });
const field = (page: Page, name: string) => card(page).getByLabel(name);
const open = (page: Page) => page.getByRole('button', { name: 'Slope tools', exact: true }).click();
const sectionOf = (text: string) => JSON.parse(/^section = (\[.*\])/m.exec(text)![1]!) as [number, number][];

test('a ditch is dragged, applied as one step and undone', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const before = await projectText(page);
  await open(page);
  await field(page, 'Toe at x').fill('13,4');
  await field(page, 'Side to the slope').fill('95');
  await expect(card(page).getByRole('alert')).toHaveText('Side to the slope: 95° is steeper than vertical.');
  await expect(card(page).getByRole('button', { name: 'Apply' })).toBeDisabled();
  await field(page, 'Side to the slope').fill('90');
  await field(page, 'Side to the road').fill('45');
  await field(page, 'Depth').fill('1');
  await field(page, 'Bottom width').fill('2');
  const [from, to] = [await pixelOf(page, [15.4, -26]), await pixelOf(page, [16.4, -26.5])];
  await drag(page, from, to, async () => {
    await expect(page.locator('.tool-hint')).toContainText(/^Depth and width: x 16\.\d\d z -26\.\d\d m/);
  });
  await expect(field(page, 'Bottom width')).toHaveValue(/^(2\.9|3)/);
  expect(await projectText(page)).toBe(before);
  await field(page, 'Depth').fill('1.5');
  await field(page, 'Bottom width').fill('3');
  await expect(card(page).getByRole('status')).toContainText('fill 0.00 m² per m');
  await card(page).getByRole('button', { name: 'Apply' }).click();
  await expect(card(page).getByRole('button', { name: 'What stays' })).toHaveAttribute('aria-pressed', 'true');
  const after = await projectText(page);
  expect(sectionOf(after).slice(0, 7)).toEqual([[0, 0], [3.1, -12.2], [6.7, -12.2], [9.8, -24.4], [13.4, -25], [13.4, -26.5], [16.4, -26.5]]);
  expect(after).toContain('] # x, z');
  expect(after).toContain('segments = ["Type One", "Type Two", "Type One", "Type Three", "Type Three", "Type Three", "Type Three", "Type Three"]');
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await projectText(page)).toBe(before);
});

test('the retained share before and after, and what stays in the ditch', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await open(page);
  await field(page, 'Depth').fill('2');
  await card(page).getByRole('button', { name: 'Compare' }).click();
  const table = card(page).getByRole('figure', { name: 'Retained share before and after' });
  await expect(table).toContainText('The same 50 rocks with the same seed', { timeout: 60_000 });
  const share = async (column: number) => parseFloat((await table.locator('tbody tr').first().locator('td').nth(column).textContent())!);
  expect(await share(1)).toBeGreaterThan(await share(0));
  // The shown run, between two places: the shares are those of the server.
  await card(page).getByRole('button', { name: 'What stays' }).click();
  await field(page, 'Toe at x').fill('9.8');
  await field(page, 'Far edge at x').fill('15');
  const answer = await page.evaluate(async () => {
    const { runs } = await (await fetch('/api/runs')).json();
    const request = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: '{"toe_m": 9.8, "far_m": 15}' };
    return (await fetch(`/api/runs/${runs.at(-1).id}/ditch`, request)).json();
  });
  await expect(card(page).locator('.big-share')).toContainText(`get beyond the far edge: ${answer.beyond.rocks} of 50`);
  await expect(card(page).locator('.slope-distances tbody tr').first()).toContainText(answer.impact.percentiles['50'][0].toFixed(2));
  await expect(card(page).getByRole('region', { name: 'Published criteria' })).toContainText('Modified Ritchie criterion');
  await field(page, 'Far edge at x').fill('99');
  await expect(card(page)).toContainText('its far edge at x = 99 is off the section');
});
