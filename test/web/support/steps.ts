// Steps that several tests share.

import { expect, type Page } from '@playwright/test';

/// Opens an example of the start page and waits until its run is shown.
export async function openExample(page: Page, title: string) {
  await page.getByRole('button', { name: new RegExp(`^${title}`) }).click();
  await runIsShown(page);
}

export async function runIsShown(page: Page) {
  await expect(page.getByRole('group', { name: 'Playback' })).toBeVisible({ timeout: 60_000 });
}

export const openForm = (page: Page, name: RegExp | string) =>
  page.getByRole('navigation', { name: 'Model' }).getByRole('button', { name }).first().click();

export const backToModel = (page: Page) => page.getByRole('button', { name: '‹ Model' }).click();

/// Starts a run with a name and a number of rocks.
export async function computeWith(page: Page, name: string, rocks: number) {
  await page.getByRole('button', { name: 'Options of the run' }).click();
  const form = page.getByRole('form', { name: 'Options of the run' });
  await form.getByLabel('Name of the run').fill(name);
  await form.getByLabel('Number of rocks in all').fill(String(rocks));
  await form.getByRole('button', { name: 'Compute this run' }).click();
}

export const runCard = (page: Page, name: string) => page.locator('li.run').filter({ hasText: name });

export const toStartPage = (page: Page) => page.getByRole('button', { name: 'Start page' }).click();

/// Opens a project of the start page.
export async function openProject(page: Page, file: string) {
  await page.getByRole('region', { name: 'Projects in this folder' }).getByRole('button', { name: file }).click();
  await expect(page.getByRole('navigation', { name: 'Model' })).toBeVisible();
}

/// Types into a field and leaves it.
export async function fillField(page: Page, label: string, value: string) {
  const field = page.getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press('Tab');
}

/// The text of the project, from the Text tab.
export async function projectText(page: Page): Promise<string> {
  await page.getByRole('tab', { name: 'Text' }).click();
  const text = await page.getByLabel('Project file').inputValue();
  await page.getByRole('tab', { name: 'Model' }).click();
  return text;
}
