// Addresses of places in the workbench: bookmarks, and Back and Forward between runs and rocks.

import type { Browser, Page } from '@playwright/test';
import { backToModel, openExample, openForm, toStartPage } from '../support/steps';
import { expect, test, type Server } from '../support/workbench';

const tab = (page: Page, name: string) => page.getByRole('tab', { name, exact: true });
const rockField = (page: Page) => page.getByRole('spinbutton', { name: 'Rock', exact: true });
const addressOf = (page: Page) => new URL(page.url()).hash;

/// Opens an address in another browser with its own session.
async function inAnotherBrowser(browser: Browser, page: Page, address: string) {
  const { address: login } = await page.evaluate(async () => {
    const headers = { 'Content-Type': 'application/json' };
    return (await (await fetch('/api/tokens', { method: 'POST', headers, body: '{}' })).json()) as { address: string };
  });
  const context = await browser.newContext({ viewport: page.viewportSize()!, reducedMotion: 'reduce' });
  const other = await context.newPage();
  // The token is replaced by the session's cookie; the part after # stays.
  await other.goto(login + address);
  return other;
}

/// Addresses tell views to a centimetre, which rounds again where a view is fitted to another window.
function expectSameAddress(address: string, expected: string) {
  const parts = (text: string) => {
    const [place, view] = text.split('&view=');
    return { place, view: view!.split(',').map(Number) };
  };
  const [mine, theirs] = [parts(address), parts(expected)];
  expect(mine.place).toBe(theirs.place);
  expect(mine.view).toHaveLength(theirs.view.length);
  mine.view.forEach((number, k) => expect(Math.abs(number - theirs.view[k]!)).toBeLessThan(0.02));
}

async function openRock(page: Page, rock: number) {
  await tab(page, 'Rock').click();
  const field = rockField(page);
  await field.fill(String(rock));
  await field.press('Enter');
  await expect.poll(() => addressOf(page)).toContain(`rock=${rock}`);
}

test('a bookmark of a section restores run, rock, form and view', async ({ workbench: page, browser }) => {
  await openExample(page, 'Tutorial 1, a section');
  expect(addressOf(page)).toMatch(/^#\/tutorial-1\/tutorial-1-2d\.toml\?panel=model&tab=overview/);
  await expect(page).toHaveTitle(/Tutorial 1.* - Talus/);
  await openForm(page, /^Type One/);
  await openRock(page, 7);
  const canvas = page.locator('.section-canvas');
  await canvas.hover({ position: { x: 300, y: 200 } });
  await page.mouse.wheel(0, -600);
  await expect.poll(() => addressOf(page)).toMatch(/&view=-?[\d.]+,-?[\d.]+,[\d.]+,[\d.]+$/);
  const address = addressOf(page);
  expect(address).toMatch(/form=material\.0&tab=rock&run=[\d-]+&rock=7&view=/);

  const other = await inAnotherBrowser(browser, page, address);
  await expect(other.getByRole('heading', { name: 'Type One', exact: true })).toBeVisible();
  await expect(tab(other, 'Rock')).toHaveAttribute('aria-selected', 'true');
  await expect(rockField(other)).toHaveValue('7');
  await expect(() => expectSameAddress(addressOf(other), address)).toPass(); // which tells what the view shows
  await other.context().close();
});

test('a bookmark of a terrain restores map and view, also after a restart of the server', async ({ workbench: page, server }) => {
  await openExample(page, 'Cliffs from a GIS');
  await tab(page, 'Maps').click();
  await page.getByRole('button', { name: 'rocks that were in the cell', exact: true }).click();
  const canvas = page.locator('.scene canvas').first();
  await canvas.press('2');
  await expect.poll(() => addressOf(page)).toMatch(/&map=passages&view=plan$/);
  await canvas.press('+');
  await expect.poll(() => addressOf(page)).toMatch(/&view=[\d.]+(,-?[\d.]+){5}$/);
  const address = page.url();

  await server.end();
  await server.startFor(page);
  await page.goto('about:blank');
  await page.goto(address);
  await expect(tab(page, 'Maps')).toHaveAttribute('aria-selected', 'true');
  await expect(page.getByRole('button', { name: 'rocks that were in the cell', exact: true })).toHaveAttribute('aria-pressed', 'true');
  await expect(() => expectSameAddress(page.url(), address)).toPass();
});

test('Back and Forward lead between rocks and runs; unsaved changes stay', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Crest/);
  await page.getByLabel('Rocks', { exact: true }).fill('60');
  await backToModel(page);
  await openRock(page, 3);
  await openRock(page, 4);
  const first = /run=[\d-]+/.exec(addressOf(page))![0];
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect.poll(() => /run=[\d-]+/.exec(addressOf(page))?.[0]).not.toBe(first);

  await page.goBack();
  await expect.poll(() => addressOf(page)).toContain(first);
  await page.goBack();
  await expect(rockField(page)).toHaveValue('3');
  await page.goForward();
  await expect(rockField(page)).toHaveValue('4');
  await expect(page.getByText('point, 60 rocks')).toBeVisible();

  await toStartPage(page);
  await expect(page.getByRole('heading', { name: 'Talus', exact: true })).toBeVisible();
  expect(addressOf(page)).toBe('');
  await page.goBack();
  await expect(rockField(page)).toHaveValue('4');
  await expect(page.getByText('60 rocks')).toBeVisible();
});

test('an address may be typed, and may be wrong', async ({ workbench: page, server }: { workbench: Page; server: Server }) => {
  server.copyExample('tutorial-1');
  const typed = (address: string) => page.evaluate((hash) => void (location.hash = hash), address);
  await typed('#/tutorial-1/tutorial-1-2d.toml?panel=text&form=seeder.9&run=gone&rock=1');
  await expect(tab(page, 'Text')).toHaveAttribute('aria-selected', 'true');
  await expect.poll(() => addressOf(page)).toMatch(/^#\/tutorial-1\/tutorial-1-2d\.toml\?panel=text&tab=overview&rock=1$/);
  await typed('#/gone.toml');
  await expect(page.getByText('gone.toml: there is no such file')).toBeVisible();
  await expect(page.getByRole('heading', { name: 'Talus', exact: true })).toBeVisible();
  expect(addressOf(page)).toBe('');
});
