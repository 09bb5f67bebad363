// Incomplete rows are kept and reported; complete rows are stored in the project.

import type { Page } from '@playwright/test';
import { openForm } from '../support/steps';
import { expect, test } from '../support/workbench';

const file = 'tutorial-1/tutorial-1-2d.toml';

async function openTutorial(page: Page, form: RegExp) {
  await page.reload();
  await page.getByRole('button', { name: /tutorial-1-2d\.toml/ }).first().click();
  await openForm(page, form);
}

async function set(page: Page, cell: string, value: string) {
  const field = page.getByLabel(cell, { exact: true });
  await field.fill(value);
  await field.press('Tab');
}

test('an incomplete row of a pasted table is kept separately', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await openTutorial(page, /^Terrain/);
  await page.getByRole('button', { name: 'Paste rows…' }).click();
  const rows = Array.from({ length: 40 }, (_, k) => (k === 19 ? `${k}` : `${k}\t${-k / 2}`));
  await page.getByLabel('Rows', { exact: true }).fill(rows.join('\n'));
  await page.getByRole('button', { name: 'Replace all rows' }).click();
  await expect(page.getByText('Row 20 is incomplete and not part of the project yet.')).toBeVisible();
  const notice = page.getByRole('region', { name: 'Incomplete entries' });
  await expect(notice).toContainText('Section of terrain, row 20');

  // It survives closing the form, saving and a reload.
  await page.getByRole('button', { name: '‹ Model' }).click();
  await expect(notice).toBeVisible();
  await page.keyboard.press('Control+s');
  await expect(page.getByText(/^Saved .*, without incomplete entries: Section of terrain, row 20/)).toBeVisible();
  const saved = server.read(file);
  expect(saved).toContain('[18, -9],\n  [20, -10],');
  await page.reload();
  await notice.getByRole('button', { name: /^Section of terrain/ }).click();
  await expect(page.getByLabel('x, row 20', { exact: true })).toHaveValue('19');
  await set(page, 'z, row 20', '-9.5');
  await expect(notice).toHaveCount(0);
  await page.keyboard.press('Control+s');
  await expect.poll(() => server.read(file)).toContain('[18, -9],\n  [19, -9.5],\n  [20, -10],');
});

test('the project keeps the previous values until a changed row is complete', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await openTutorial(page, /^Terrain/);
  await set(page, 'x, row 2', '');
  await expect(page.getByText('Row 2 is incomplete; the project keeps the previous values.')).toBeVisible();
  await page.getByRole('button', { name: 'Discard Section of terrain, row 2' }).click();
  await expect(page.getByLabel('x, row 2', { exact: true })).toHaveValue('3.1');

  await page.getByRole('button', { name: '‹ Model' }).click();
  await openForm(page, /^Crest/);
  await set(page, 'Position, x', '');
  await expect(page.getByText('Incomplete: enter x. Until then the project keeps the previous value.')).toBeVisible();
  await page.getByRole('button', { name: '‹ Model' }).click();
  const notice = page.getByRole('region', { name: 'Incomplete entries' });
  await notice.getByRole('button', { name: 'Position of Crest', exact: true }).click();
  await expect(page.getByLabel('Position, x', { exact: true })).toHaveValue('');
  await set(page, 'Position, x', '0.75');
  await expect(notice).toHaveCount(0);
});

test('an invalid cell is marked and reported by row and column', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await openTutorial(page, /^Terrain/);
  await set(page, 'x, row 4', 'abc');
  const field = page.getByRole('group', { name: /^Section/ });
  await expect(field.getByText('section, row 4, x is "abc" (expected a number)')).toBeVisible();
  await expect(page.getByLabel('x, row 4', { exact: true })).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByLabel('z, row 4', { exact: true })).toHaveAttribute('aria-invalid', 'false');
});
