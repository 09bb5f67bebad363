// The answers of a run come first: forms fold away, four cards stand above the view with their ranges, and the sheet
// prints them with all inputs.

import type { Page } from '@playwright/test';
import { findings } from '../support/findings';
import { openExample } from '../support/steps';
import { expect, test } from '../support/workbench';

test.use({ answersFirst: true });

const answers = (page: Page) => page.getByRole('region', { name: 'Answers', exact: true });
const card = (page: Page, title: RegExp) => answers(page).getByRole('region', { name: title });
const row = (page: Page, title: RegExp, name: string) => card(page, title).locator(`tr.${name} td`).first();

test('a run answers first, and its sheet has the answers and the inputs', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  // The forms are a strip, the tables their tabs.
  const side = page.getByRole('complementary', { name: 'Model and runs' });
  await expect(side).toHaveClass(/folded/);
  await expect(page.getByRole('table', { name: /^Statistics/ })).toBeHidden();
  // The collector of the project is the place; the figures are those of its line.
  const state = await page.evaluate(async () => {
    const { runs } = await (await fetch('/api/runs')).json();
    const request = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ barrier: 'Line at 15 m' }) };
    return (await fetch(`/api/runs/${runs[0].id}/line`, request)).json();
  });
  await expect(card(page, /^Passes Line at 15 m/)).toContainText(`${100 * state.whole.share.value} %`);
  await expect(row(page, /^Passes/, 'sampling')).toHaveText(state.card.share_interval);
  await expect(card(page, /^95 % energy there/)).toContainText(/kJ translational.*kJ total/);
  await expect(card(page, /^95 % height of the block's top/)).toContainText(state.card.height);
  await expect(card(page, /^Fence needed/)).toContainText(/2 class.*stretches/);
  // What if begins by itself, over inputs and models.
  await expect(row(page, /^Passes/, 'inputs')).toHaveText(/ to .* %$/, { timeout: 30_000 });
  await expect(row(page, /^Passes/, 'models')).toHaveText(/ to .* %$/);
  await expect(row(page, /^Passes/, 'models')).toHaveAttribute('title', /^lumped mass .*\(this run\), rigid sphere .*, rigid body /);
  await expect(answers(page).getByRole('button', { name: 'Stop' })).toBeHidden();
  await expect(answers(page).locator('.doubts')).toContainText('passed above it');
  expect(await findings(page, '.answers')).toEqual([]);

  // On paper.
  await page.evaluate(() => (window.print = () => undefined));
  await answers(page).getByRole('button', { name: 'A4 sheet' }).click();
  const sheet = page.locator('.answer-sheet');
  for (const text of ['Line at 15 m, 3.5 m high, 50.0 m long: x, y [m] (15.00, 0.00) (15.00, 50.00)', '78.2 to 96.7 %', 'By UNI 11211-4 at MEL, with γ', 'passed above it', 'Prepared', 'Signature'])
    await expect(sheet.locator('article').first()).toContainText(text);
  const inputs = sheet.locator('article').last();
  for (const text of ['lumped mass: laws rocfall', '50 rocks, seed 1', 'mass 1,000 kg; 2,700 kg/m³', 'along a line of 2 points', 'Type Three', 'own values', 'rock model rigid sphere', 'Rock mass −25 %'])
    await expect(inputs).toContainText(text);
  await expect(inputs.locator('.checksums .mono')).toHaveText(/^[0-9a-f]{64}$/);
  await expect(sheet.locator('img')).toHaveJSProperty('complete', true);
  const pdf = await page.pdf({ preferCSSPageSize: true });
  expect(pdf.toString('latin1').match(/\/Type \/Page\b/g)).toHaveLength(2);
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  await expect(sheet).toHaveCount(0);

  // Another line, asked in the card, is answered above, too; Undo takes it back.
  await answers(page).getByRole('combobox', { name: 'Place of the answers' }).selectOption({ label: 'Draw another line…' });
  await page.keyboard.press('Escape');
  const asked = page.getByRole('region', { name: 'Ask a line' });
  await asked.getByText('Points, x and y [m]').click();
  for (const [k, [x, y]] of [[10, 0], [10, 50]].entries()) {
    await asked.getByRole('textbox', { name: `x, row ${k + 1}`, exact: true }).fill(String(x));
    await asked.getByRole('textbox', { name: `y, row ${k + 1}`, exact: true }).fill(String(y));
    await asked.getByRole('textbox', { name: `y, row ${k + 1}`, exact: true }).press('Tab');
  }
  await expect(card(page, /^Passes the asked line/)).toBeVisible();
  await expect(row(page, /^Passes/, 'inputs')).toHaveText(/ %( in each)?$/, { timeout: 30_000 }); // for this line

  // The keyboard brings the forms back, and they stay when the next run ends.
  await side.getByRole('button', { name: 'Runs' }).press('Enter');
  await expect(side.getByRole('tab', { name: 'Runs' })).toBeFocused();
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(page.locator('li.run')).toHaveCount(2);
  await expect(page.locator('li.run').first()).toContainText('Done');
  await expect(side.getByRole('tab', { name: 'Runs' })).toBeVisible();
});

test('without a line the page says how to choose one, and how far rocks go', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  const text = server.read('tutorial-1/tutorial-1-2d.toml');
  server.write('bare.toml', text.replace(/\[\[collector\]\][^[]*/, ''));
  await page.reload();
  await page.getByRole('region', { name: 'Projects in this folder' }).getByRole('button', { name: /bare\.toml/ }).click();
  await expect(answers(page)).toBeHidden();
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(card(page, /^Choose a place/)).toContainText('Pick the road');
  await expect(card(page, /^95 % of the rocks stop within/)).toContainText(/\d m/);
  await expect(card(page, /^Leave the model/)).toContainText('of 50 rocks');
  await card(page, /^Choose a place/).getByRole('button', { name: 'Where half of them stop' }).click();
  await expect(card(page, /^Passes x = [\d.]+ m/)).toContainText('%');
  await page.keyboard.press('Control+z');
  await expect(card(page, /^Choose a place/)).toBeVisible();
});

test('ensembles of the run give the range over inputs', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  const text = server.read('tutorial-1/tutorial-1-2d.toml');
  const sets = Array.from({ length: 10 }, (_, k) => 0.6 + 0.03 * k);
  server.write('posterior.csv', ['material.*.tangential_restitution.mean', ...sets].join('\n'));
  server.write('uncertain.toml', `${text.replace(/^rocks = \d+/m, 'rocks = 500')}\n[sampling]\nparameters = "posterior.csv"\nensembles = 10\n`);
  await page.reload();
  await page.getByRole('region', { name: 'Projects in this folder' }).getByRole('button', { name: /uncertain\.toml/ }).click();
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(row(page, /^Passes/, 'inputs')).toHaveText(/ to .* %$/, { timeout: 30_000 });
  await expect(row(page, /^Passes/, 'inputs')).toHaveAttribute('title', /^90 % of the run's 10 ensembles, /);
  await expect(row(page, /^Fence needed/, 'inputs')).toHaveText(/^\d/);
  await expect(row(page, /^Fence needed/, 'models')).toHaveText(/^\d/, { timeout: 30_000 });
  await page.evaluate(() => (window.print = () => undefined));
  await answers(page).getByRole('button', { name: 'A4 sheet' }).click();
  await expect(page.locator('.answer-sheet article').first()).toContainText('Inputs: the range of 90 % of the 10 ensembles of this run', { timeout: 40_000 });
});

test('a sheet that is asked for early waits for the ranges, or says that they were not there yet', async ({ workbench: page }) => {
  await page.addInitScript(() => (window.print = () => undefined));
  await page.reload();
  await openExample(page, 'Tutorial 1, in 3D');
  const sheet = page.locator('.answer-sheet');
  const waits = page.getByRole('status', { name: 'The sheet waits' });
  await answers(page).getByRole('button', { name: 'A4 sheet' }).click();
  await expect(waits).toContainText('The sheet is printed with the ranges over inputs and models');
  await waits.getByRole('button', { name: 'Print now, without' }).click();
  await expect(sheet.locator('article').first()).toContainText('Inputs and rock models were still being computed when this sheet was printed');
  await expect(sheet).not.toContainText('not varied');
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  // Once more, as soon as the page is there again: it is printed by itself.
  await answers(page).getByRole('button', { name: 'A4 sheet' }).click();
  await expect(sheet.locator('.answer-card.share tr.models td').first()).toHaveText(/ to .* %/, { timeout: 30_000 });
  await expect(sheet).not.toContainText('being computed');
  await expect(waits).toBeHidden();
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
});
