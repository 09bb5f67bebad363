// Use by keyboard and screen reader.

import type { Page } from '@playwright/test';
import { backToModel, computeWith, fillField, openExample, openForm, projectText, runCard } from '../support/steps';
import { expect, test } from '../support/workbench';

test('Enter renames a run, Escape does not, and the focus stays', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Runs' }).click();
  const name = page.getByRole('button', { name: /: rename$/ });
  const before = await name.innerText();
  await name.press('Enter');
  await page.keyboard.type('Not kept');
  await page.keyboard.press('Escape');
  await expect(name).toBeFocused();
  await expect(name).toHaveText(before);
  await name.press('Enter');
  await page.keyboard.type('Kept');
  await page.keyboard.press('Enter');
  await expect(name).toBeFocused();
  await expect(name).toHaveText('Kept');
});

test('the end of a run is announced, and deleting a run focuses the next one', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await computeWith(page, 'Second', 60);
  await expect(page.getByRole('banner').getByRole('status')).toHaveText('Second: Done');
  await page.getByRole('tab', { name: 'Runs' }).click();
  const remove = async (run: ReturnType<typeof runCard>) => {
    await run.getByRole('button', { name: 'Delete' }).press('Enter');
    await page.getByRole('dialog').getByRole('button', { name: 'Delete' }).press('Enter');
  };
  await remove(runCard(page, 'Second'));
  await expect(runCard(page, 'Second')).toHaveCount(0);
  await expect(page.getByRole('button', { name: /: rename$/ })).toBeFocused();
  await remove(page.locator('li.run'));
  await expect(page.locator('li.run')).toHaveCount(0);
  await expect(page.getByRole('tab', { name: 'Runs' })).toBeFocused();
});

test('Undo in the text editor covers changes of forms and of the text', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const first = await projectText(page);
  await openForm(page, /^Crest/);
  await fillField(page, 'Rocks', '77');
  await page.getByRole('tab', { name: 'Text' }).click();
  const text = page.getByLabel('Project file');
  await text.press('Control+Home');
  await page.keyboard.type('hello');
  await expect(text).toHaveValue(/^hello.*rocks = 77/s);
  await page.keyboard.press('Control+z');
  await expect(text).toHaveValue(/rocks = 77/);
  await expect(text).not.toHaveValue(/hello/);
  expect(await text.evaluate((field: HTMLTextAreaElement) => field.selectionStart)).toBe(0);
  await page.keyboard.press('Control+z');
  await expect(text).toHaveValue(first);
  await page.keyboard.press('Control+y');
  await page.keyboard.press('Control+y');
  await expect(text).toHaveValue(/^hello.*rocks = 77/s);
});

/// Checks the accessible description of a field with an invalid value.
async function expectDescribed(page: Page, label: string, value: string, description: RegExp) {
  await fillField(page, label, value);
  const field = page.getByLabel(label, { exact: true });
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  await expect(field).toHaveAccessibleDescription(description);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(field).toHaveAttribute('aria-invalid', 'false');
}

test('errors describe their fields', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Crest/);
  await expectDescribed(page, 'Position, x', 'abc', /position, x is "abc"/);
  await expectDescribed(page, 'Horizontal velocity: standard deviation', '-1', /std_dev is -1/);
  await expectDescribed(page, 'Horizontal velocity: relative minimum', '0;5', /rel_min is "0;5"/);
  await fillField(page, 'Direction, x', '1');
  await expect(page.getByLabel('Direction, x', { exact: true })).toHaveAccessibleDescription(/Incomplete: enter z/);
  await backToModel(page);
  await openForm(page, /^Line at 15 m/);
  await expectDescribed(page, 'Line, x', 'abc', /line is "abc"/);
});
