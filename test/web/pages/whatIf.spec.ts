// What if: the card varies the inputs, and a change becomes a run with the figures that the card gave it.

import { findings } from '../support/findings';
import { openExample, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

test('inputs are varied beside a run, and a change is opened as a run of its own', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  const text = await projectText(page);
  await page.getByRole('button', { name: 'Ask a line', exact: true }).click();
  const card = page.getByRole('region', { name: 'Ask a line' });
  await card.getByLabel('Barrier or collector').selectOption('Line at 15 m');
  await card.getByRole('button', { name: 'Vary the inputs', exact: true }).click();
  await expect(card.getByRole('button', { name: 'Vary the inputs again' })).toBeVisible({ timeout: 30_000 });
  const state = await page.evaluate(async () => {
    const { runs } = await (await fetch('/api/runs')).json();
    return (await fetch(`/api/runs/${runs[0].id}/what_if`)).json();
  });
  expect(state.answer.rocks).toBe(50);

  // Every step has a row; the tornado a bar. A row or a bar chooses.
  const rows = card.locator('.what-if-table tr');
  await expect(rows).toHaveCount(state.answer.variations.length);
  await expect(card.locator('.asked-what-if rect.bar')).toHaveCount(state.answer.variations.length);
  const { share, text: values, changes } = state.answer.variations.find(
    (each: { factor: string; step_percent: number }) => each.factor === 'tangential_restitution' && each.step_percent === -10,
  );
  const name = 'Tangential restitution −10 %';
  await rows.filter({ hasText: name }).getByRole('button').press('Enter');
  await expect(card.locator('.what-if-chosen')).toContainText(values);
  await expect(rows.filter({ hasText: 'Rock model: rigid sphere' })).toHaveCount(1);
  await card.getByLabel('Figure of what if').selectOption('energy_J');
  await expect(card.locator('.what-if-table caption')).toHaveText(/^Change of the 95 % (translational|total) energy, for the same rocks$/);
  expect(await findings(page, '.ask-card')).toEqual([]);

  // A reload finds the job again.
  await page.reload();
  await expect(rows).toHaveCount(state.answer.variations.length);

  // An input alone, by another step.
  const choices = card.locator('.what-if-choices');
  await choices.locator('summary').click();
  for (const box of await choices.getByRole('checkbox').all()) await box.uncheck();
  await expect(card.getByRole('button', { name: 'Vary the inputs again' })).toBeDisabled();
  await choices.getByLabel('Tangential restitution', { exact: true }).check();
  const step = choices.getByLabel('Step of tangential restitution');
  await step.fill('120');
  await card.getByRole('button', { name: 'Vary the inputs again' }).click();
  await expect(card.getByRole('alert')).toContainText('the step of tangential_restitution is 120 %');
  await step.fill('10');
  await card.getByRole('button', { name: 'Vary the inputs again' }).click();
  await expect(rows.filter({ hasNotText: 'Rock model' })).toHaveText([/^Tangential restitution −10 %/, /^Tangential restitution \+10 %/]);
  await rows.filter({ hasText: name }).getByRole('button').click();
  await card.getByRole('button', { name: 'Open as a run of its own' }).click();
  await expect(page.locator('li.run').first()).toContainText(name);
  await expect(card.locator('.big-share').first()).toContainText(`${(100 * share[0]).toFixed(1)} %`, { timeout: 30_000 });
  // The run has the value, and the open project is as it was.
  const changed = await page.evaluate(async () => {
    const { runs } = await (await fetch('/api/runs')).json();
    return (await fetch(`/api/runs/${runs[0].id}/files/project.toml`)).text();
  });
  expect(changed).toContain(`tangential_restitution = { mean = ${changes[0].after.mean}`);
  expect(await projectText(page)).toBe(text);
});
