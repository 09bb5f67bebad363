// Rare cases: an invalid rock number, integers beyond double precision, Windows line ends, a failed save, a failed run.

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { openExample, openForm, runIsShown } from '../support/steps';
import { expect, test } from '../support/workbench';

const file = 'tutorial-1/tutorial-1-2d.toml';
const open = async (page: Page) => {
  await page.reload();
  await page.getByRole('button', { name: /tutorial-1-2d\.toml/ }).first().click();
};

test('rock numbers are zero-based, and one rock is not "rocks"', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  writeFileSync(join(server.folder, file), server.read(file).replace('rocks = 50', 'rocks = 1'));
  await open(page);
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await runIsShown(page);
  await page.getByRole('tab', { name: 'Rock', exact: true }).click();
  const rock = page.getByLabel('Rock', { exact: true }).and(page.locator('input'));
  await rock.fill('0');
  await rock.press('Enter');
  await rock.fill('1');
  await rock.press('Enter');
  await expect(rock).toHaveValue('0');
  await expect(page.getByText('There is no rock 1. Rocks are numbered from 0 to 0.')).toBeVisible();
  await page.getByRole('tab', { name: 'Distributions' }).click();
  await expect(page.getByText('1 rock', { exact: true })).toBeVisible();
  const curve = page.getByRole('img', { name: /^Share of rocks/ }).locator('path.step, path.curve');
  await expect(curve).toBeVisible();
  await expect(page.getByText(/\b1 rocks\b/)).toHaveCount(0);
});

test('integers keep all digits, and numbers out of range are reported', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  writeFileSync(join(server.folder, file), `${server.read(file)}\n[sampling]\nseed = 9007199254740993\n`);
  await open(page);
  await openForm(page, /^Sampling/);
  const seed = page.getByLabel('Seed', { exact: true });
  await expect(seed).toHaveValue('9007199254740993');
  await seed.fill('9007199254740995');
  await seed.press('Tab');
  await page.keyboard.press('Control+s');
  await expect.poll(() => server.read(file)).toContain('seed = 9007199254740995');
  await seed.fill('1e999');
  await seed.press('Tab');
  await expect(seed).toHaveAttribute('aria-invalid', 'true');
  await expect(page.locator('.form-page').getByText(/it is too large or too small to be represented/)).toBeVisible();
});

test('the text editor keeps Windows line ends', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  const unix = server.read(file);
  writeFileSync(join(server.folder, file), unix.replaceAll('\n', '\r\n'));
  await open(page);
  await page.getByRole('tab', { name: 'Text' }).click();
  await page.getByLabel('Project file').press('Control+End');
  await page.keyboard.type('# end\n# of it');
  await page.keyboard.press('Control+s');
  await expect.poll(() => server.read(file)).toBe(`${unix}# end\n# of it`.replaceAll('\n', '\r\n'));
});

test('a failure of Save as is shown in its dialog', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  await open(page);
  mkdirSync(join(server.folder, 'other.toml.part'));
  await page.getByRole('button', { name: 'Save as…' }).click();
  await page.getByLabel('Name of the file in the folder').fill('other');
  await page.getByRole('button', { name: 'Save', exact: true }).last().click();
  await expect(page.getByRole('dialog').getByRole('alert')).toContainText('Choose another folder');
});

test('a failed run can be resumed', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, a section');
  await server.end();
  const names = readdirSync(server.folder, { recursive: true }).map(String);
  const path = join(server.folder, names.find((name) => name.endsWith('run.json'))!);
  writeFileSync(path, readFileSync(path, 'utf8').replace('"done",', '"failed",'));
  await server.startFor(page);
  await page.getByRole('tab', { name: 'Runs' }).click();
  const run = page.locator('li.run');
  await expect(run).toContainText('Failed', { timeout: 30_000 });
  await run.getByRole('button', { name: 'Resume' }).click();
  await expect(run).toContainText('Done');
});

test('each of many segments offers all materials when focused', async ({ workbench: page, server }) => {
  const materials = Array.from({ length: 60 }, (_, k) => `[[material]]\nname = "M ${k}"\n`).join('');
  const section = Array.from({ length: 101 }, (_, k) => `[${k}, ${-k}]`).join(', ');
  server.write('many.toml', `[terrain]\nsection = [${section}]\n[ground]\ndefault = "M 7"\n${materials}`);
  await page.reload();
  await page.getByRole('button', { name: /many\.toml/ }).first().click();
  await openForm(page, /^Ground/);
  await page.getByLabel('Where materials are').selectOption('segments');
  const last = page.getByLabel('Material of segment 100', { exact: true });
  await expect(last).toHaveValue('M 7');
  await expect(last.locator('option')).toHaveCount(1);
  await last.focus();
  await expect(last.locator('option')).toHaveCount(60);
  await last.selectOption('M 59');
  await expect(last).toHaveValue('M 59');
});
