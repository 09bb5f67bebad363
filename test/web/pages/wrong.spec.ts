// Invalid values are marked at their fields with the engine's message, in every form.

import type { Page } from '@playwright/test';
import { backToModel, openForm, openProject } from '../support/steps';
import { expect, test, type Server } from '../support/workbench';

interface Invalid {
  form: RegExp;
  field: string | RegExp;
  value: string;
  message: RegExp;
}

const inTheTutorial: Invalid[] = [
  { form: /^Project and analysis/, field: 'Gravity m/s²', value: '-1', message: /gravity/ },
  { form: /^Terrain/, field: 'Width m', value: '-5', message: /width/ },
  { form: /^Type One/, field: 'Normal restitution: mean', value: '1.5', message: /rebound cannot gain energy/ },
  { form: /^Crest/, field: 'Rocks', value: '-3', message: /rocks/ },
  { form: /^Line at 15 m/, field: 'Height m', value: '-1', message: /height/ },
  { form: /^Sampling/, field: 'Seed', value: '-1', message: /seed/ },
  { form: /^Output/, field: /^Map cell size/, value: '-2', message: /raster_cell/ },
];
const onTheVolcano: Invalid[] = [
  { form: /^Half way/, field: 'Inclination °', value: '95', message: /inclination_deg/ },
  { form: /^Barrier design/, field: 'Section m', value: '-10', message: /section_m/ },
];

/// Opens a project of an example without a run, which would take most of the time.
async function open(page: Page, server: Server, example: string, project: string) {
  server.copyExample(example);
  await page.reload();
  await openProject(page, project);
}

async function expectMarks(page: Page, all: Invalid[]) {
  for (const { form, field, value, message } of all) {
    await openForm(page, form);
    const name = { name: field, exact: typeof field === 'string' };
    const input = page.getByRole('textbox', name).or(page.getByRole('combobox', name)).first();
    await input.fill(value);
    await input.press('Tab');
    await expect(input, `${form}`).toHaveAttribute('aria-invalid', 'true');
    await expect(page.locator('.side').getByText(message).filter({ visible: true }).first()).toBeVisible();
    await expect(page.getByRole('button', { name: 'Compute', exact: true })).toBeDisabled();
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(input).toHaveAttribute('aria-invalid', 'false');
    await expect(page.getByRole('button', { name: 'Compute', exact: true })).toBeEnabled();
    await backToModel(page);
  }
}

test('an invalid value is marked until it is undone', async ({ workbench: page, server }) => {
  await open(page, server, 'tutorial-1', 'tutorial-1-3d.toml');
  await expectMarks(page, inTheTutorial);
});

test('a design, ground, barrier and area of a real terrain', async ({ workbench: page, server }) => {
  await open(page, server, 'maungawhau', 'barrier-design.toml');
  await expectMarks(page, onTheVolcano);

  // A raster of classes without its classes.
  await openForm(page, /^Ground/);
  await page.getByLabel('Where materials are').selectOption('raster');
  await page.getByLabel('Raster', { exact: true }).selectOption('maungawhau.asc');
  const classes = page.getByRole('group', { name: /^Classes/ });
  await expect(classes.getByText(/the materials of its classes are not given/)).toBeVisible();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(classes).toHaveCount(0);
  await backToModel(page);

  await page.getByRole('button', { name: '+ Add barrier' }).click();
  const capacity = page.getByRole('textbox', { name: /^Capacity/ });
  await capacity.fill('-100');
  await capacity.press('Tab');
  await expect(capacity).toHaveAttribute('aria-invalid', 'true');
  await expect(page.locator('.side').getByText(/it would stop nothing/).filter({ visible: true }).first()).toBeVisible();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(capacity).toHaveAttribute('aria-invalid', 'false');
  await page.getByRole('button', { name: 'Undo' }).click();

  await page.getByRole('button', { name: '+ Add area' }).click();
  await expect(page.getByText('material is missing', { exact: true })).toBeVisible();
  await expect(page.getByText('polygon is missing', { exact: true })).toBeVisible();
  await page.getByRole('combobox', { name: 'Material', exact: true }).selectOption('Bare lava');
  await expect(page.getByText('material is missing', { exact: true })).toBeHidden();
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('button', { name: 'Compute', exact: true })).toBeEnabled();
});
