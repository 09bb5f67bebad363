// Pasted and typed numbers with commas are read correctly, or the page asks.

import type { Page } from '@playwright/test';
import { fillField, openExample, openForm, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

const newSection = (page: Page) => page.getByRole('button', { name: /Section, 2D/ }).click();
const dialog = (page: Page) => page.getByRole('dialog', { name: 'Paste rows' });
const section = async (page: Page) => /section = \[[\s\S]*?\]\n/.exec(await projectText(page))?.[0].replace(/\s+/g, ' ');

async function pasteInto(page: Page, cell: string, text: string) {
  await page.getByLabel(cell, { exact: true }).focus();
  await page.evaluate((copied) => {
    const data = new DataTransfer();
    data.setData('text', copied);
    const event = new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true });
    document.activeElement!.dispatchEvent(event);
  }, text);
}

test('an ambiguous thousands separator is asked about, unless another number decides', async ({ workbench: page }) => {
  await newSection(page);
  await page.getByRole('button', { name: 'Paste rows…' }).click();
  await dialog(page).getByLabel('Rows').fill('x\tz\n0\t1,250\n10\t1,240\n20\t998');
  const take = dialog(page).getByRole('button', { name: 'Add the rows' });
  await expect(take).toBeDisabled();
  await expect(dialog(page).getByRole('group', { name: 'How should 1,250 be read?' })).toBeVisible();
  await dialog(page).getByLabel('1250: commas separate thousands').check();
  await take.click();
  await expect.poll(() => section(page)).toContain('[0, 1250], [10, 1240], [20, 998]');

  await page.getByRole('button', { name: 'Paste rows…' }).click();
  await dialog(page).getByLabel('Rows').fill('0\t1.250,5\n10\t1.240\n20\t998,25');
  await expect(dialog(page).getByRole('group')).toHaveCount(0);
  await dialog(page).getByRole('button', { name: 'Replace all rows' }).click();
  await expect.poll(() => section(page)).toContain('[0, 1250.5], [10, 1240], [20, 998.25]');
});

test('a single column is not split', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Terrain/);
  await pasteInto(page, 'z, row 2', '1,100\n1,090');
  await dialog(page).getByLabel('1100: commas separate thousands').check();
  await dialog(page).getByRole('button', { name: 'Paste from z, row 2' }).click();
  await expect.poll(() => section(page)).toContain('[3.1, 1100], [6.7, 1090]');
});

test('pasting more columns than the table has opens the dialog', async ({ workbench: page }) => {
  await newSection(page);
  await pasteInto(page, 'x, row 1', '0\t500\t100\n10\t501\t90');
  await expect(dialog(page).getByText('Row 1 has 3 columns; only the first 2 are used.')).toBeVisible();
  await dialog(page).getByLabel('Rows').fill('0\t100\n10\t90');
  await dialog(page).getByRole('button', { name: 'Paste from x, row 1' }).click();
  await expect.poll(() => section(page)).toContain('[0, 100], [10, 90]');
  await pasteInto(page, 'z, row 2', '10\t80\n20\t70');
  await dialog(page).getByRole('button', { name: 'Paste from x, row 2' }).click();
  await expect.poll(() => section(page)).toContain('[0, 100], [10, 80], [20, 70]');
});

test('a decimal comma in a list is reported with the correct form', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await openForm(page, /^Output/);
  const percentiles = page.getByLabel('Percentiles', { exact: true });
  await fillField(page, 'Percentiles', '50, 97,5');
  await expect(page.locator('.field').getByText(/"97,5".*Write 97\.5$/)).toBeVisible();
  await expect(percentiles).toHaveAttribute('aria-invalid', 'true');
  await fillField(page, 'Percentiles', '50, 97.5');
  await expect(percentiles).toHaveAttribute('aria-invalid', 'false');
  expect(await projectText(page)).toContain('percentiles = [50, 97.5]');
});
