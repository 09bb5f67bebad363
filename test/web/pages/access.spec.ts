// Accessibility: use by the keyboard alone, and no serious findings of axe-core.

import { seriousFindings } from '../support/findings';
import { openExample, runIsShown } from '../support/steps';
import { expect, test } from '../support/workbench';

test('an example can be opened, changed and run by the keyboard', async ({ workbench: page }) => {
  const example = page.getByRole('button', { name: /^Tutorial 1, a section/ });
  await expect(example).toBeVisible();
  while (!(await example.evaluate((element) => element === document.activeElement))) await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await runIsShown(page);
  const material = page.getByRole('button', { name: /^Type One/ });
  for (let k = 0; k < 60 && !(await material.evaluate((element) => element === document.activeElement)); ++k)
    await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  const mean = page.getByLabel('Normal restitution: mean');
  for (let k = 0; k < 60 && !(await mean.evaluate((element) => element === document.activeElement)); ++k)
    await page.keyboard.press('Tab');
  await page.keyboard.press('Control+a');
  await page.keyboard.type('0.47');
  await page.keyboard.press('Control+Enter');
  await page.getByRole('tab', { name: 'Runs' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('li.run')).toHaveCount(2);
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`no serious findings, ${colorScheme}`, async ({ workbench: page }) => {
    await page.emulateMedia({ colorScheme });
    await expect(page.getByRole('button', { name: /^Tutorial 1, a section/ })).toBeVisible();
    expect(await seriousFindings(page), 'start page').toEqual([]);
    await openExample(page, 'Tutorial 1, in 3D');
    expect(await seriousFindings(page), 'workbench').toEqual([]);
    // A tab changes one panel alone.
    const results = '.results';
    for (const tab of ['Overview', 'Distributions', 'Barriers', 'Rock', 'Maps', 'Compare']) {
      await page.getByRole('tab', { name: tab, exact: true }).click();
      await expect(page.getByRole('tabpanel', { name: tab })).toBeVisible();
      expect(await seriousFindings(page, results), tab).toEqual([]);
    }
    await page.getByRole('tab', { name: 'Section', exact: true }).click();
    for (const [row, value] of ['10', '40'].entries()) {
      await page.getByRole('textbox', { name: `x, row ${row + 1}`, exact: true }).fill(value);
      await page.getByRole('textbox', { name: `y, row ${row + 1}`, exact: true }).fill(value);
    }
    await expect(page.getByRole('img', { name: /^Elevation of the ground/ })).toBeVisible();
    expect(await seriousFindings(page, results), 'Section').toEqual([]);
    await page.getByRole('button', { name: /^Type One/ }).click();
    expect(await seriousFindings(page, '.side'), 'a form').toEqual([]);
    await page.getByRole('tab', { name: 'Runs' }).click();
    expect(await seriousFindings(page, '.side'), 'runs').toEqual([]);
  });
}
