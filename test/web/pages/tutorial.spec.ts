// Tutorial 1: edit, run, stop, run again, compare, undo.

import { backToModel, computeWith, openExample, openForm, runCard, runIsShown } from '../support/steps';
import { expect, test } from '../support/workbench';

test('a run is stopped and deleted, another is compared with the first', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Type One/);
  await page.getByLabel('Normal restitution: mean').fill('0.45');
  await page.getByLabel('Normal restitution: mean').press('Tab');

  await computeWith(page, 'Long', 50_000_000);
  const long = runCard(page, 'Long');
  await expect(long.getByRole('progressbar')).toBeVisible();
  await long.getByRole('button', { name: 'Stop' }).click();
  await expect(long).toContainText(/Stopped/, { timeout: 30_000 });
  await long.getByRole('button', { name: 'Delete' }).click();
  await page.getByRole('dialog').getByRole('button', { name: /Delete/ }).click();
  await expect(long).toHaveCount(0);

  await computeWith(page, 'Softer', 50);
  await expect(runCard(page, 'Softer')).toContainText('Done');
  await runIsShown(page);
  await runCard(page, 'Tutorial 1, section').getByRole('button', { name: 'Compare' }).click();
  await page.getByRole('tab', { name: 'Compare' }).click();
  await expect(page.getByRole('row', { name: /normal_restitution.*mean/ }).first()).toContainText('0.45');
  await expect(page.getByRole('img', { name: /^Histogram of runout on plan/ })).toBeVisible();
});

// The response arrives while the number of rocks is being typed, and renders the form again.
test('typed text stays in its field when the model arrives late', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  let answer = () => {};
  const isTyping = new Promise<void>((resolve) => (answer = resolve));
  await page.route(/\/api\/model$/, async (route) => {
    await isTyping;
    await route.continue();
  });
  await openForm(page, /^Type One/);
  await page.getByLabel('Normal restitution: mean').fill('0.45');
  const asked = page.waitForRequest(/\/api\/model$/);
  await page.getByLabel('Normal restitution: mean').press('Tab');
  await asked;
  await page.getByRole('button', { name: 'Options of the run' }).click();
  const rocks = page.getByLabel('Number of rocks in all');
  await rocks.pressSequentially('12');
  const answered = page.waitForResponse(/\/api\/model$/);
  answer();
  await answered;
  await expect(page.getByText('checking…')).toHaveCount(0);
  await page.keyboard.type('34');
  await expect(rocks).toHaveValue('1234');
  await expect(page.getByLabel('Name of the run')).toHaveValue('');
});

test('twenty steps are undone and redone', async ({ workbench: page }) => {
  test.setTimeout(180_000);
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Text' }).click();
  const text = page.getByRole('textbox', { name: 'Project file' });
  const texts = [await text.inputValue()];
  await page.getByRole('tab', { name: 'Model' }).click();
  for (let k = 0; k < 20; ++k) {
    await page.getByRole('button', { name: '+ Add collector' }).click();
    await backToModel(page);
  }
  await page.getByRole('tab', { name: 'Text' }).click();
  texts.push(await text.inputValue());
  expect(texts[1]!.match(/\[\[collector\]\]/g)).toHaveLength(21);
  const undo = page.getByRole('button', { name: 'Undo' });
  for (let k = 0; k < 20; ++k) await undo.click();
  await expect(text).toHaveValue(texts[0]!);
  await expect(undo).toBeDisabled();
  for (let k = 0; k < 20; ++k) await page.keyboard.press('Control+y');
  await page.getByRole('button', { name: 'Compute', exact: true }).focus();
  for (let k = 0; k < 20; ++k) await page.keyboard.press('Control+y');
  await expect(text).toHaveValue(texts[1]!);
});

test('displayed numbers have all digits of the files', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  const runs = await page.evaluate(async () => (await fetch('/api/runs')).json());
  const folder: string = runs.runs[0].folder;
  const summary = JSON.parse(server.read(`${folder}/summary.json`));
  await page.getByRole('tab', { name: 'Overview' }).click();
  await page.getByRole('checkbox', { name: 'All digits' }).check();
  const mean = page.getByRole('region', { name: /Statistics over all rocks/ }).getByRole('row', { name: /^Mean/ });
  await expect(mean).toContainText(String(summary.statistics.runout_xy_m.mean));
  const inKilojoules = String(summary.statistics.max_ke_J.mean).replace(/(\d{3})\./, '.$1');
  await expect(mean).toContainText(inKilojoules);

  await page.getByRole('tab', { name: 'Barriers' }).click();
  const counts = page.getByRole('row', { name: /^Line at 15 m/ });
  const hits = server.read(`${folder}/barriers.csv`).trim().split('\n').length - 1;
  await expect(page.getByText(`${hits} hits`)).toBeVisible();
  await expect(counts).toBeVisible();
});
