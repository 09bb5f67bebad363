// Rows that are not complete: the others are taken, they wait, and everyone who should know of them is told.

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

test('of a pasted table all is taken but the row that lacks a number', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await openTutorial(page, /^Terrain/);
  await page.getByRole('button', { name: 'Paste rows…' }).click();
  const rows = Array.from({ length: 40 }, (_, k) => (k === 19 ? `${k}` : `${k}\t${-k / 2}`));
  await page.getByLabel('Rows', { exact: true }).fill(rows.join('\n'));
  await page.getByRole('button', { name: 'Replace all rows' }).click();
  await expect(page.getByText('Row 20 is not complete: the project does not have it yet.')).toBeVisible();
  const notice = page.getByRole('region', { name: 'Not complete' });
  await expect(notice).toContainText('Section of terrain, row 20');

  // It outlives the form, saving and a reload.
  await page.getByRole('button', { name: '‹ Model' }).click();
  await expect(notice).toBeVisible();
  await page.keyboard.press('Control+s');
  await expect(page.getByText(/^Saved .*, without what is not complete: Section of terrain, row 20/)).toBeVisible();
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

test('what is changed stays as it was until it is complete', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await openTutorial(page, /^Terrain/);
  await set(page, 'x, row 2', '');
  await expect(page.getByText('Row 2 is not complete: the project keeps it as before.')).toBeVisible();
  await page.getByRole('button', { name: 'Discard Section of terrain, row 2' }).click();
  await expect(page.getByLabel('x, row 2', { exact: true })).toHaveValue('3.1');

  await page.getByRole('button', { name: '‹ Model' }).click();
  await openForm(page, /^Crest/);
  await set(page, 'Position, x', '');
  await expect(page.getByText('Taken when x is given, too; the project keeps it as before.')).toBeVisible();
  await page.getByRole('button', { name: '‹ Model' }).click();
  const notice = page.getByRole('region', { name: 'Not complete' });
  await notice.getByRole('button', { name: 'Position of Crest', exact: true }).click();
  await expect(page.getByLabel('Position, x', { exact: true })).toHaveValue('');
  await set(page, 'Position, x', '0.75');
  await expect(notice).toHaveCount(0);
});

test('a cell that is wrong is marked, and told by its row and column', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await openTutorial(page, /^Terrain/);
  await set(page, 'x, row 4', 'abc');
  const field = page.getByRole('group', { name: /^Section/ });
  await expect(field.getByText('section, row 4, x is "abc" (expected a number)')).toBeVisible();
  await expect(page.getByLabel('x, row 4', { exact: true })).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByLabel('z, row 4', { exact: true })).toHaveAttribute('aria-invalid', 'false');
});
