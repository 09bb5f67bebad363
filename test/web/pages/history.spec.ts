// Back and Forward of the browser within the workbench.

import type { Page } from '@playwright/test';
import { openExample, openForm } from '../support/steps';
import { expect, test } from '../support/workbench';

const heading = (page: Page, name: string) => page.getByRole('heading', { name, exact: true });

test('Back leads from forms, tabs and projects to the start page, and Forward returns', async ({ workbench: page }) => {
  await expect(heading(page, 'Talus')).toBeVisible();
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type One/);
  await expect(heading(page, 'Type One')).toBeVisible();
  await page.getByRole('tab', { name: 'Distributions' }).click();
  await page.getByRole('tab', { name: 'Runs' }).click();

  await page.goBack();
  await expect(heading(page, 'Type One')).toBeVisible();
  await expect(page.getByRole('tab', { name: 'Distributions' })).toHaveAttribute('aria-selected', 'true');
  await page.goBack();
  await expect(page.getByRole('tab', { name: 'Overview' })).toHaveAttribute('aria-selected', 'true');
  await page.goBack();
  await expect(page.getByRole('navigation', { name: 'Model' })).toBeVisible();
  await page.goBack();
  await expect(heading(page, 'Talus')).toBeVisible();
  await expect(page.getByRole('button', { name: /^Tutorial 1, a section/ })).toBeVisible();

  await page.goForward();
  await expect(page.getByRole('navigation', { name: 'Model' })).toBeVisible();
  await page.goForward();
  await expect(heading(page, 'Type One')).toBeVisible();
});

test('unsaved changes survive Back and Forward', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Crest/);
  await page.getByLabel('Rocks', { exact: true }).fill('77');
  await page.goBack();
  await page.goBack();
  await expect(heading(page, 'Talus')).toBeVisible();
  await page.goForward();
  await expect(page.getByText('77 rocks')).toBeVisible();
});

test('the verification page is a step of the history', async ({ workbench: page }) => {
  await page.getByRole('button', { name: 'Run the verification cases' }).click();
  await expect(page.getByRole('button', { name: /^Tutorial 1, a section/ })).toHaveCount(0);
  await page.goBack();
  await expect(page.getByRole('button', { name: /^Tutorial 1, a section/ })).toBeVisible();
});
