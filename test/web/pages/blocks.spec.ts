// Rocks with shapes are drawn as blocks of their true size.

import type { Page } from '@playwright/test';
import { pixelsLike, type Rgb } from '../support/pixels';
import { openProject, runIsShown } from '../support/steps';
import { expect, test, type Server } from '../support/workbench';

const accent: Rgb = [31, 95, 120]; // of the selected rock, in the light theme
const mass = 3000; // kg
const volume = mass / 2700; // m3

const project = (terrain: string, position: string, shape: string) => `name = "Blocks"

[analysis]
model = "rigid_body"

[terrain]
section = [[0, 20], [10, 10], [80, 8]]
${terrain}
[[material]]
name = "Scree"
normal_restitution = 0.35
dynamic_friction = 0.6
rolling_friction = 0.1

[ground]
segments = ["Scree", "Scree"]

[[seeder]]
position = ${position}
height_above_m = 1.5
rocks = 1
mass_kg = ${mass}
shape = "${shape}"

[output]
report = false
`;

/// Runs a project and shows its rock, selected, in a view that follows from the rock's end point.
async function showEnd(page: Page, server: Server, text: string, viewOf: (end: number[]) => number[]) {
  server.write('blocks.toml', text);
  await page.reload();
  await openProject(page, 'blocks.toml');
  await page.getByRole('button', { name: 'Compute', exact: true }).click();
  await runIsShown(page);
  const [run, end] = await page.evaluate(async () => {
    const { runs } = await (await fetch('/api/runs')).json();
    const { endpoint } = await (await fetch(`/api/runs/${runs[0].id}/rocks/0`)).json();
    return [runs[0].id as string, ['x_m', 'y_m', 'z_m'].map((key) => Number(endpoint[key]))] as const;
  });
  await page.goto(`${new URL(server.address).origin}/#/blocks.toml?panel=model&tab=overview&run=${run}&rock=0&view=${viewOf(end).join(',')}`);
}

test('a block in a section is a polygon of its area', async ({ workbench: page, server }) => {
  const across = 8; // m
  await showEnd(page, server, project('', '[3]', 'hexagon'), ([x, , z]) => [x!, z!, across, across]);
  const { width, height } = (await page.locator('.picture canvas').first().boundingBox())!;
  const scale = Math.min(width, height) / across;
  const expected = volume ** (2 / 3) * scale ** 2;
  const area = async () => (await pixelsLike(page, [accent], 12))[0]! / expected;
  await expect.poll(area).toBeGreaterThan(0.9);
  expect(await area()).toBeLessThan(1.02);
});

test('a block in space has its size, until it would be smaller than a dot', async ({ workbench: page, server }) => {
  await showEnd(page, server, project('width_m = 30\n', '[3, 15]', 'cube'), ([x, y, z]) => [x! + 6, y! - 6, z! + 4, x!, y!, z!]);
  const area = async () => (await pixelsLike(page, [accent], 70))[0]!;
  // A cube covers between its face and its largest shadow.
  const canvas = page.locator('.picture canvas').first();
  const { height } = (await canvas.boundingBox())!;
  const scale = height / (2 * Math.hypot(6, 6, 4) * Math.tan((16 * Math.PI) / 180));
  const face = volume ** (2 / 3) * scale ** 2;
  await expect.poll(area).toBeGreaterThan(0.9 * face);
  expect(await area()).toBeLessThan(2 * face);
  await canvas.focus();
  for (let k = 0; k < 25; ++k) await page.keyboard.press('-');
  await canvas.blur(); // the frame of the focus has the same colour
  await expect.poll(area).toBeLessThan(0.2 * face); // text and legends
});
