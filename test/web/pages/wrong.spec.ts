// A wrong value is marked at its field, with the engine's own words, in every form.

import { backToModel, openExample, openForm } from '../support/steps';
import { expect, test } from '../support/workbench';

const wrong: { form: RegExp; field: string | RegExp; value: string; says: RegExp }[] = [
  { form: /^Project and analysis/, field: 'Gravity m/s²', value: '-1', says: /gravity/ },
  { form: /^Terrain/, field: 'Width m', value: '-5', says: /width/ },
  { form: /^Type One/, field: 'Normal restitution: mean', value: '1.5', says: /rebound cannot gain energy/ },
  { form: /^Crest/, field: 'Rocks', value: '-3', says: /rocks/ },
  { form: /^Line at 15 m/, field: 'Height m', value: '-1', says: /height/ },
  { form: /^Sampling/, field: 'Seed', value: '-1', says: /seed/ },
  { form: /^Output/, field: /^Cell of the maps/, value: '-2', says: /raster_cell/ },
];

test('each is marked, and its undoing heals it', async ({ workbench: page }) => {
  test.setTimeout(180_000);
  await openExample(page, 'Tutorial 1, in 3D');
  for (const { form, field, value, says } of wrong) {
    await openForm(page, form);
    const name = { name: field, exact: typeof field === 'string' };
    const input = page.getByRole('textbox', name).or(page.getByRole('combobox', name)).first();
    await input.fill(value);
    await input.press('Tab');
    await expect(input, `${form}`).toHaveAttribute('aria-invalid', 'true');
    await expect(page.locator('.side').getByText(says).filter({ visible: true }).first()).toBeVisible();
    await expect(page.getByRole('button', { name: 'Compute', exact: true })).toBeDisabled();
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(input).toHaveAttribute('aria-invalid', 'false');
    await expect(page.getByRole('button', { name: 'Compute', exact: true })).toBeEnabled();
    await backToModel(page);
  }
});
