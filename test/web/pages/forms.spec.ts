// Forms: typed values, choices and disabled fields.

import { fillField, openExample, openForm, backToModel, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

test('the field of a number accepts a decimal comma', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type One/);
  const field = page.getByLabel('Normal restitution: mean', { exact: true });
  await field.fill('');
  await field.pressSequentially('0,35');
  await field.press('Tab');
  await expect(field).toHaveValue('0.35');
  await expect(field).toHaveAttribute('aria-invalid', 'false');
  expect(await projectText(page)).toContain('mean = 0.35');
  // This may mean 1000, so the engine reports how to write it.
  await backToModel(page);
  await openForm(page, /^Crest/);
  await fillField(page, 'Mass: mean', '1,000');
  await expect(page.getByLabel('Mass: mean', { exact: true })).toHaveAttribute('aria-invalid', 'true');
});

test('the library of materials adds a material only when one is chosen', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const before = await projectText(page);
  const library = page.getByRole('button', { name: '+ From the library…' });
  await library.focus();
  await page.keyboard.press('ArrowDown');
  expect(await projectText(page)).toBe(before);
  await library.press('Enter');
  const dialog = page.getByRole('dialog', { name: 'Add materials from the library' });
  await expect(dialog).toBeVisible();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  expect(await projectText(page)).toBe(before);
  await library.press('Enter');
  // The dialog stays open for more materials.
  await dialog.getByRole('button', { name: 'Add Talus cover', exact: true }).press('Enter');
  await dialog.getByRole('button', { name: 'Add Asphalt roadway', exact: true }).press('Enter');
  await expect(dialog.getByRole('row', { name: 'Talus cover Add Talus cover' })).toContainText('in the project');
  await page.keyboard.press('Escape');
  await expect(library).toBeFocused();
  const text = await projectText(page);
  expect(text).toContain('like = "talus_cover"');
  expect(text).toContain('like = "asphalt"');
});

test('a library material with changed values is marked and offered another name', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('button', { name: '+ From the library…' }).click();
  await page.getByRole('button', { name: 'Add Talus cover', exact: true }).click();
  await page.keyboard.press('Escape');
  await openForm(page, /^Talus cover/);
  const notice = page.getByText('Named like “Talus cover” of the library, with other values of: normal restitution.');
  await expect(notice).toHaveCount(0);
  await fillField(page, 'Normal restitution: mean', '0.6');
  await expect(notice).toBeVisible();
  await backToModel(page);
  await expect(page.getByRole('navigation', { name: 'Model' }).getByRole('button', { name: /^Talus cover/ })).toContainText('changed');
  await openForm(page, /^Talus cover/);
  await page.getByRole('button', { name: 'Rename to “Talus cover, changed”' }).click();
  await expect(page.getByLabel('Name', { exact: true })).toHaveValue('Talus cover, changed');
  await expect(notice).toHaveCount(0);
});

test('settings of the other rock model are disabled with a reason', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type One/);
  const [sphere, lumped] = [page.getByLabel('Rolling friction: mean'), page.getByLabel('Friction angle: mean')];
  await expect(sphere).toBeDisabled();
  await expect(lumped).toBeEnabled();
  const group = page.getByRole('group', { name: /^Rolling friction/ });
  await expect(group).toContainText('Applies only to the rigid sphere model; the rock model is lumped mass.');
  await backToModel(page);
  await openForm(page, /^Project and analysis/);
  const rotation = page.getByLabel('Rotation', { exact: true });
  await expect(rotation).toBeEnabled();
  await page.getByLabel('Rock model', { exact: true }).selectOption('rigid sphere');
  await expect(rotation).toBeDisabled();
  await backToModel(page);
  await openForm(page, /^Type One/);
  await expect(sphere).toBeEnabled();
  await expect(lumped).toBeDisabled();
});

test('maps are chosen one by one', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await openForm(page, /^Output/);
  const maps = page.getByRole('group', { name: 'Maps', exact: true });
  const [velocity, energy] = [maps.getByLabel('velocity'), maps.getByLabel('energy total')];
  await maps.getByRole('button', { name: 'None' }).click();
  expect(await projectText(page)).toContain('maps = false');
  await expect(velocity).not.toBeChecked();
  await velocity.check();
  await energy.check();
  expect(await projectText(page)).toContain('maps = ["energy_total", "velocity"]');
  await velocity.uncheck();
  expect(await projectText(page)).toContain('maps = ["energy_total"]');
  await maps.getByRole('button', { name: 'All' }).click();
  expect(await projectText(page)).toContain('maps = true');
  await expect(velocity).toBeChecked();
});

test('an error disappears when it no longer applies', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const errors = page.locator('.messages .error');
  await page.getByRole('tab', { name: 'Text' }).click();
  const text = page.getByLabel('Project file');
  const valid = await text.inputValue();
  await text.fill(`${valid}\n[`);
  await page.getByRole('tab', { name: 'Model' }).click();
  await page.getByRole('button', { name: '+ Add collector' }).click();
  await expect(errors).toContainText('Could not add a collector');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(errors).toHaveCount(0);
  // The error of a run disappears when the text changes.
  const isBroken = (url: URL) => url.pathname === '/api/runs';
  await page.route(isBroken, (route) => route.abort());
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(errors).toHaveCount(1);
  await openForm(page, /^Crest/);
  await fillField(page, 'Rocks', '5');
  await expect(errors).toHaveCount(0);
  // The error of a run disappears when the next one succeeds.
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(errors).toHaveCount(1);
  await page.unroute(isBroken);
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(errors).toHaveCount(0);
});
