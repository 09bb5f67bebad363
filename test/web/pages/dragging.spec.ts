// Vertices and lines are dragged in the views; context menus of what is under the pointer.

import type { Page } from '@playwright/test';
import { drag, pixelOf } from '../support/places';
import { openExample, openForm, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

const undo = (page: Page) => page.getByRole('button', { name: 'Undo' }).click();
const menuItem = (page: Page, name: string) => page.getByRole('menu').getByRole('menuitem', { name });
const numbersOf = (text: string, key: string): number[][] =>
  JSON.parse(new RegExp(`^${key} = (\\[.*\\])`, 'm').exec(text)![1]!) as number[][];

test.describe('in a section', () => {
  test.beforeEach(async ({ workbench: page }) => {
    await openExample(page, 'Tutorial 1, a section');
  });

  test('a vertex of the slope is dragged as one step', async ({ workbench: page }) => {
    await openForm(page, /^Terrain/);
    const before = await projectText(page);
    const [from, to] = [await pixelOf(page, [9.8, -24.4]), await pixelOf(page, [11, -21])];
    await drag(page, from, to, async () => {
      await expect(page.locator('.tool-hint')).toContainText(/^Vertex 4 of the section: x 1[01]\.\d\d z -2[01]\.\d\d m/);
    });
    await expect.poll(async () => (await projectText(page)) !== before).toBe(true);
    const section = numbersOf(await projectText(page), 'section');
    expect(Math.abs(section[3]![0]! - 11)).toBeLessThan(0.2);
    expect(Math.abs(section[3]![1]! + 21)).toBeLessThan(0.2);
    expect(section.filter((_, k) => k !== 3)).toEqual(numbersOf(before, 'section').filter((_, k) => k !== 3));
    await undo(page);
    expect(await projectText(page)).toBe(before);
  });

  test('Escape ends a drag without a change', async ({ workbench: page }) => {
    await openForm(page, /^Terrain/);
    const before = await projectText(page);
    const [from, to] = [await pixelOf(page, [9.8, -24.4]), await pixelOf(page, [11, -21])];
    await drag(page, from, to, () => page.keyboard.press('Escape'));
    await expect(page.locator('.tool-hint')).toHaveCount(0);
    expect(await projectText(page)).toBe(before);
  });

  test('a collector snaps to a vertex, and with Ctrl to a grid', async ({ workbench: page }) => {
    await openForm(page, /^Line at 15 m/);
    const [from, to] = [await pixelOf(page, [15, -24.8]), await pixelOf(page, [13.4, -25])];
    await drag(page, from, [to[0] + 5, to[1] - 3], async () => {
      await expect(page.locator('.tool-hint')).toContainText('Line at 15 m: x 13.40 m, on a vertex of the section');
    });
    await expect.poll(() => projectText(page)).toContain('line = 13.4');
    await page.keyboard.down('Control');
    await drag(page, await pixelOf(page, [13.4, -25]), await pixelOf(page, [17.03, -24]));
    await page.keyboard.up('Control');
    await expect.poll(() => projectText(page)).toMatch(/^line = 17(\.0)?$/m);
  });

  test('a click on a collector opens it', async ({ workbench: page }) => {
    await page.mouse.click(...(await pixelOf(page, [15, -24])));
    await expect(page.getByRole('heading', { name: 'Line at 15 m' })).toBeVisible();
  });

  test('vertices are inserted and deleted from the menu', async ({ workbench: page }) => {
    await openForm(page, /^Terrain/);
    const before = await projectText(page);
    await page.mouse.click(...(await pixelOf(page, [20, -23.7])), { button: 'right' });
    await menuItem(page, 'Insert a vertex here').click();
    const section = () => projectText(page).then((text) => numbersOf(text, 'section'));
    await expect.poll(async () => (await section()).length).toBe(7);
    expect(Math.abs((await section())[5]![0]! - 20)).toBeLessThan(0.2);
    await page.mouse.click(...(await pixelOf(page, (await section())[5] as [number, number])), { button: 'right' });
    await menuItem(page, 'Delete vertex 6').click();
    await expect.poll(() => section()).toEqual(numbersOf(before, 'section'));
  });

  test('a place, a collector and a trajectory have menus, also by the keyboard', async ({ workbench: page }) => {
    await page.mouse.click(...(await pixelOf(page, [15, -24])), { button: 'right' });
    await expect(page.getByRole('menu', { name: 'Line at 15 m' })).toBeVisible();
    await menuItem(page, 'Copy Line at 15 m').click();
    await expect.poll(async () => (await projectText(page)).match(/\[\[collector\]\]/g)?.length).toBe(2);
    await undo(page);

    await page.mouse.click(...(await pixelOf(page, [22, -6])), { button: 'right' });
    await menuItem(page, 'Add a seeder here').click();
    await expect.poll(() => projectText(page)).toMatch(/position = \[2[12](\.\d+)?, "surface"\]/);

    const canvas = page.locator('.section-canvas');
    await canvas.focus();
    await page.keyboard.press('ContextMenu');
    await expect(page.getByRole('menu')).toBeVisible();
    await page.keyboard.press('ArrowDown');
    await expect(page.getByRole('menuitem').nth(1)).toBeFocused();
    await page.keyboard.press('Escape');
    await expect(page.getByRole('menu')).toHaveCount(0);
    await expect(canvas).toBeFocused();
  });
});

test.describe('over a terrain', () => {
  test.beforeEach(async ({ workbench: page }) => {
    await openExample(page, 'Tutorial 1, in 3D');
    await page.locator('.scene canvas').first().press('2'); // plan
    await page.locator('.scene canvas').first().press('8'); // of the whole model
    await page.waitForTimeout(400);
  });

  test('a vertex and a line are dragged; the view stays', async ({ workbench: page }) => {
    await openForm(page, /^Line at 15 m/);
    const before = await projectText(page);
    await expect(page.getByText(/"line"|line = \[\[15, 0\], \[15, 50\]\]/)).toHaveCount(0);
    const [from, to] = [await pixelOf(page, [15, 50]), await pixelOf(page, [18, 44])];
    const address = page.url();
    await drag(page, from, to, async () => {
      await expect(page.locator('.tool-hint')).toContainText(/^Vertex 2 of Line at 15 m: x 1[78]\.\d\d y 4[34]\.\d\d m/);
    });
    const line = () => projectText(page).then((text) => numbersOf(text, 'line'));
    await expect.poll(async () => Math.abs((await line())[1]![0]! - 18)).toBeLessThan(0.3);
    expect((await line())[0]).toEqual([15, 0]);
    await page.waitForTimeout(500);
    expect(page.url()).toBe(address); // the view has not turned

    const now = await line();
    const [a, b] = [await pixelOf(page, [16.5, 22]), await pixelOf(page, [14.5, 22])];
    await drag(page, a, b);
    await expect.poll(async () => Math.abs((await line())[0]![0]! - 13)).toBeLessThan(0.4);
    const moved = await line();
    expect(moved[1]![0]! - moved[0]![0]!).toBeCloseTo(now[1]![0]! - now[0]![0]!, 1);
    await undo(page);
    await undo(page);
    expect(await projectText(page)).toBe(before);
  });

  test('the right button moves the view, and without a movement opens a menu', async ({ workbench: page }) => {
    const at = await pixelOf(page, [20, 25]);
    await page.mouse.move(...at);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(at[0] - 30, at[1] + 20, { steps: 3 });
    await page.mouse.up({ button: 'right' });
    await expect(page.getByRole('menu')).toHaveCount(0);
    await expect.poll(() => page.url()).toMatch(/view=[-\d.,]+$/);
    await page.mouse.click(...(await pixelOf(page, [20, 25])), { button: 'right' });
    await menuItem(page, 'Add a seeder here').click();
    await expect.poll(() => projectText(page)).toMatch(/position = \[(19\.9|20)\d*(\.\d+)?, 2[45](\.\d+)?, "surface"\]/);
  });
});
