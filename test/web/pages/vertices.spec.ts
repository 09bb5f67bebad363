// Adding and deleting vertices of a section also updates its materials and deviations, in the same step.

import type { Page } from '@playwright/test';
import { backToModel, fillField, openForm, openProject, projectText } from '../support/steps';
import { expect, test } from '../support/workbench';

const slope = `[terrain]
section = [[0, 30], [10, 20], [20, 10], [40, 0]]
section_std_dev_m = [[0, 0], [0, 0.5], [0, 0.2], [0, 0]]

[[material]]
name = "Rock"
normal_restitution = 0.5
tangential_restitution = 0.9

[[material]]
name = "Scree"
normal_restitution = 0.3
tangential_restitution = 0.8

[[material]]
name = "Soil"
normal_restitution = 0.2
tangential_restitution = 0.7

[ground]
segments = ["Rock", "Scree", "Soil"]

[[seeder]]
position = [1, "surface"]
height_above_m = 1
mass_kg = 100
`;

test('the vertices of a section in a file come into the project', async ({ workbench: page, server }) => {
  server.write('profile.csv', 'distance_m,z_m\n0,30\n10,20.004\n20,10\n40,0\n');
  const inFile = slope.replace(/section = .*\nsection_std_dev_m = .*\n/, 'section = "profile.csv"\nsection_tolerance_m = 0.01\n');
  server.write('slope.toml', inFile.replace('["Rock", "Scree", "Soil"]', '["Rock", "Scree"]'));
  await page.reload();
  await openProject(page, 'slope.toml');
  await openForm(page, /Terrain/);
  await expect(page.locator('.file-control select')).toHaveValue('profile.csv');
  await page.getByRole('button', { name: 'Take the vertices into the project' }).click();
  const text = await projectText(page);
  expect(text).toContain('section = [[0, 30], [20, 10], [40, 0]]');
  expect(text).not.toContain('section_tolerance_m');
  await expect(page.getByText(/\d errors?/)).toHaveCount(0);
});

async function openSlope(page: Page, write: (name: string, content: string) => void, text: string) {
  write('slope.toml', text);
  await page.reload();
  await openProject(page, 'slope.toml');
}

test('segments keep their materials and vertices their deviations', async ({ workbench: page, server }) => {
  await openSlope(page, server.write.bind(server), slope);
  await openForm(page, /^Terrain/);
  const section = page.getByRole('table', { name: 'Section', exact: true });
  await section.getByRole('button', { name: 'Insert a row above row 3' }).click();
  await section.getByLabel('x, row 3').fill('15');
  await section.getByLabel('z, row 3').fill('16');
  await section.getByLabel('z, row 3').press('Tab');
  let text = await projectText(page);
  expect(text).toContain('section = [[0, 30], [10, 20], [15, 16], [20, 10], [40, 0]]');
  expect(text).toContain('section_std_dev_m = [[0, 0], [0, 0.5], [0, 0], [0, 0.2], [0, 0]]');
  expect(text).toContain('segments = ["Rock", "Scree", "Scree", "Soil"]');

  await section.getByRole('button', { name: 'Delete row 2' }).click();
  text = await projectText(page);
  expect(text).toContain('section = [[0, 30], [15, 16], [20, 10], [40, 0]]');
  expect(text).toContain('section_std_dev_m = [[0, 0], [0, 0], [0, 0.2], [0, 0]]');
  expect(text).toContain('segments = ["Rock", "Scree", "Soil"]');

  const undo = page.getByRole('button', { name: 'Undo' });
  await undo.click();
  await undo.click();
  expect(await projectText(page)).toBe(slope);
});

test('a list that is too short is marked and not filled up automatically', async ({ workbench: page, server }) => {
  await openSlope(page, server.write.bind(server), slope.replace(', "Soil"]', ']'));
  await openForm(page, /^Ground/);
  await expect(page.getByText('The project lists 2 materials for 3 segments.')).toBeVisible();
  const third = page.getByLabel('Material of segment 3');
  await expect(third).toHaveValue('');
  await expect(third).toHaveAttribute('aria-invalid', 'true');
  const give = async (segment: number, material: string) => {
    const choice = page.getByLabel(`Material of segment ${segment}`);
    await choice.focus(); // options are added on focus
    await choice.selectOption(material);
  };
  await give(1, 'Soil');
  expect(await projectText(page)).toContain('segments = ["Soil", "Scree"]');
  await give(3, 'Soil');
  await expect(page.getByText(/The project lists/)).toHaveCount(0);
  expect(await projectText(page)).toContain('segments = ["Soil", "Scree", "Soil"]');
});

test('a height above the ground replaces a missing z', async ({ workbench: page, server }) => {
  await openSlope(page, server.write.bind(server), slope.replace(/position[^]*?height_above_m = 1\n/, ''));
  await openForm(page, /^seeder 1/);
  await fillField(page, 'Position, x', '3');
  await expect(page.getByText('Incomplete: enter z or a height above.')).toBeVisible();
  await fillField(page, 'Height above m', '0.5');
  await expect(page.getByText(/Incomplete: enter/)).toHaveCount(0);
  await expect(page.getByText('position is missing')).toHaveCount(0);
  await backToModel(page);
  expect(await projectText(page)).toMatch(/position = \[3\]/);
});
