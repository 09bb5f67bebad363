// Tooltips and legends of figures.

import type { Page } from '@playwright/test';
import { openExample } from '../support/steps';
import { expect, test } from '../support/workbench';

const tip = (page: Page) => page.locator('#tip');

test('bars and boxes show their numbers under the pointer', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Distributions' }).click();
  const bars = page.locator('.drawing .bar');
  await bars.first().hover();
  await expect(tip(page)).toHaveText(/^[\d.]+ to [\d.]+ m\s\d+ of 50 rocks \([\d.]+ %\)$/);
  await page.locator('.drawing .box').first().hover();
  await expect(tip(page)).toHaveText(/^All: 50\smaximum [\d.]+ m\supper quartile [\d.]+ m\smedian /);
  await page.getByRole('heading', { name: 'Box plots' }).hover();
  await expect(tip(page)).toBeHidden();
});

test('the legend of envelopes switches curves, and the tooltip shows all of them', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Envelopes' }).click();
  const mean = page.locator('path.envelope.mean');
  await expect(mean).toBeVisible();
  const entry = page.locator('.drawing .switch', { hasText: 'mean' });
  await entry.click();
  await expect(mean).toBeHidden();
  await entry.click();
  await expect(mean).toBeVisible();
  await page.locator('.drawing .under-pointer').hover();
  await expect(tip(page)).toHaveText(/^x \d+ to \d+ m\smaximum [\d.]+ kJ\spercentile 99 [\d.]+ kJ\s.*mean [\d.]+ kJ$/s);
});

test('the energies of a rock add up in the tooltip', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Rock' }).click();
  await page.getByRole('button', { name: 'First' }).click();
  const figure = page.locator('.chart', { hasText: 'Energy over time' });
  await expect(figure.locator('path.energy')).toHaveCount(4);
  await figure.locator('.under-pointer').hover();
  const text = await tip(page).textContent();
  const [mechanical, kinetic, potential] = ['mechanical', 'total kinetic', 'potential'].map((name) =>
    Number(new RegExp(`${name} ([\\d.,−]+) kJ`).exec(text!)![1]!.replace('−', '-').replace(',', '')),
  );
  expect(Math.abs(kinetic! + potential! - mechanical!)).toBeLessThan(0.2); // of roundings to four digits
});

test('results are shown in feet on request; settings and places stay metric', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Distributions' }).click();
  const mean = page.locator('.data-table').filter({ hasText: 'Statistics' }).getByRole('row', { name: 'Mean' }).locator('td');
  await expect(mean).toHaveText(/^[\d.]+$/);
  const metres = Number(await mean.textContent());
  const units = page.getByRole('button', { name: /^Units of results/ });
  await units.click();
  const quantity = page.locator('label.choice').filter({ hasText: 'Quantity' }).locator('select');
  await expect(quantity.locator('option:checked')).toHaveText('Runout on plan [ft]');
  await expect.poll(async () => Number(await mean.textContent())).toBeCloseTo(metres / 0.3048, 1);
  await quantity.selectOption('x_m');
  await expect(page.locator('.drawing').first()).toContainText('[m]');
  await page.reload();
  await expect(units).toHaveText('ft');
});
