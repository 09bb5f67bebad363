// Barriers and collectors: their tables, and the cost of drawing them.

import { openExample } from '../support/steps';
import { expect, test } from '../support/workbench';

test('collectors stop nothing and have no capacity', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('tab', { name: 'Barriers' }).click();
  const collectors = page.getByRole('region', { name: 'Collectors', exact: true });
  await expect(collectors.getByRole('columnheader')).toHaveText([/^Name/, /^Height/, /^Rocks that passed/, /^Passed above/]);
  await expect(page.getByRole('region', { name: 'Barriers', exact: true })).toHaveCount(0);
});

test('tables show rounded numbers first', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await page.getByRole('tab', { name: 'Rock' }).click();
  await page.getByRole('button', { name: 'First' }).click();
  const path = page.getByRole('region', { name: /^Trajectory of rock 0/ });
  await expect(path).toBeVisible();
  const longest = () =>
    path.locator('td.number').evaluateAll((cells) => Math.max(...cells.map((cell) => cell.textContent!.replace(/[^\d]/g, '').length)));
  expect(await longest()).toBeLessThanOrEqual(7);
  await page.getByRole('checkbox', { name: 'All digits' }).check();
  expect(await longest()).toBeGreaterThan(12);
});

test('a long collector needs few draw calls', async ({ workbench: page }) => {
  await page.addInitScript(() => {
    const draws = { now: 0, most: 0 }; // draw calls per frame, which begins with clear()
    Object.assign(window, { draws });
    const prototype = WebGL2RenderingContext.prototype as unknown as Record<string, (...all: unknown[]) => void>;
    const spyOn = (name: string, task: () => void) => {
      const own = prototype[name]!;
      prototype[name] = function (this: unknown, ...all: unknown[]) {
        task();
        own.apply(this, all);
      };
    };
    for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'])
      spyOn(name, () => (draws.most = Math.max(draws.most, ++draws.now)));
    spyOn('clear', () => (draws.now = 0));
  });
  await page.reload();
  await openExample(page, 'Maungawhau');
  await page.getByRole('button', { name: '+ Add collector' }).click();
  await page.getByRole('tab', { name: 'Text' }).click();
  const text = page.getByLabel('Project file');
  const ring = 'line = [[20, 20], [580, 20], [580, 840], [20, 840], [20, 30]]'; // 2.8 km, draped over the cells
  await text.fill(`${(await text.inputValue()).trimEnd()}\n${ring}\n`);
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(page.getByRole('banner').getByRole('status')).toHaveText(/: Done$/);
  await page.evaluate(() => Object.assign((window as unknown as { draws: object }).draws, { most: 0 }));
  await page.locator('.picture canvas').first().hover();
  await page.mouse.wheel(0, -1);
  const most = () => page.evaluate(() => (window as unknown as { draws: { most: number } }).draws.most);
  await expect.poll(most).toBeGreaterThan(10);
  expect(await most()).toBeLessThan(200);
});
