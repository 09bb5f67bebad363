// Viewing a run: clicking a trajectory, themes, filtering rocks, measuring distances.

import { openExample } from '../support/steps';
import { expect, test } from '../support/workbench';

test('the rocks of a new run are played, unless the user prefers reduced motion', async ({ workbench: page }) => {
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await openExample(page, 'Tutorial 1, in 3D');
  await page.getByRole('button', { name: 'Pause' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await expect(page.getByRole('banner').getByRole('status')).toHaveText(/: Done$/);
  await expect(page.getByRole('slider', { name: 'Time' })).toHaveAttribute('aria-valuetext', /^([\d.]+) of \1 s$/);
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
});

test('a click on a trajectory in the section selects its rock', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  expect((await page.getByRole('toolbar', { name: 'View' }).boundingBox())!.height).toBeLessThan(40); // one row
  const box = (await page.getByRole('img', { name: /^The slope in section/ }).boundingBox())!;
  // All rocks pass the upper face, so a row of clicks across it hits a trajectory.
  const field = page.getByRole('spinbutton', { name: 'Rock' });
  for (let share = 0.36; share < 0.46 && !(await field.isVisible()); share += 0.006)
    await page.mouse.click(box.x + share * box.width, box.y + 0.42 * box.height);
  await expect(field).toBeVisible();
  await expect(field).toHaveValue(/^\d+$/);
  await expect(page.getByRole('region', { name: /^Trajectory of rock \d+/ })).toBeVisible();
});

test('the theme follows the system or the choice', async ({ workbench: page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await openExample(page, 'Tutorial 1, a section');
  const grounds = { light: 'rgb(244, 242, 238)', dark: 'rgb(20, 25, 28)' };
  const expectGround = (shade: keyof typeof grounds) =>
    expect(page.locator('body')).toHaveCSS('background-color', grounds[shade]);
  const plotText = () => page.locator('.drawing .axis-label').first().evaluate((text) => getComputedStyle(text).fill);
  await page.getByRole('tab', { name: 'Distributions' }).click();
  await expectGround('light');
  await expect.poll(plotText).toBe('rgb(29, 35, 38)');
  await page.emulateMedia({ colorScheme: 'dark' });
  await expectGround('dark');
  await expect.poll(plotText).toBe('rgb(232, 236, 238)');
  await page.getByRole('button', { name: 'Theme: system' }).click();
  await expectGround('light');
  await expect.poll(plotText).toBe('rgb(29, 35, 38)');
  await page.getByRole('button', { name: 'Theme: light' }).click();
  await expectGround('dark');
  await page.reload();
  await expectGround('dark');
});

test('the filter of the view applies to the figures', async ({ workbench: page, server }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await page.locator('summary', { hasText: 'Filter' }).click();
  await page.getByRole('checkbox', { name: 'Line at 15 m' }).check();
  await page.getByRole('tab', { name: 'Distributions' }).click();
  const runs = await page.evaluate(async () => (await fetch('/api/runs')).json());
  const lines = server.read(`${runs.runs[0].folder}/barriers.csv`).trim().split('\n').slice(1);
  const rocks = new Set(lines.map((line: string) => line.split(',')[1]));
  await expect(page.getByText(`${rocks.size} of 50 rocks`)).toBeVisible();
  await page.getByRole('button', { name: 'All rocks' }).first().click();
  await expect(page.getByText('50 rocks', { exact: true })).toBeVisible();
});

test('distances are measured on the ground', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await page.getByRole('button', { name: 'Distance' }).click();
  const picture = page.getByRole('img', { name: /^The slope in section/ });
  const box = (await picture.boundingBox())!;
  const place = async (x: number, y: number) => {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    const [, px, pz] = /x (\S+) z (\S+) m/.exec((await page.locator('.status-line').textContent())!)!;
    return [Number(px), Number(pz)] as const;
  };
  const [a, b] = [await place(0.3, 0.5), await place(0.7, 0.6)];
  const hint = (await page.locator('.tool-hint').textContent())!;
  const plan = Number(/([\d.]+) m on plan/.exec(hint)![1]);
  expect(Math.abs(plan - Math.abs(b[0] - a[0]))).toBeLessThan(0.02);
});
