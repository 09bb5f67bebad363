// Choosing, dropping and replacing files.

import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { openForm, openProject, projectText, toStartPage } from '../support/steps';
import { expect, sources, test } from '../support/workbench';

const valley = join(sources, 'examples/first-gis-run/valley.tif');
const terrainFile = (page: Page) => page.getByLabel('Terrain file', { exact: true });
const asked = (page: Page, name: string) => page.getByRole('dialog', { name: `Replace ${name}?` });

/// Drops a file on the page. Returns whether the page accepted it.
const drop = (page: Page, name: string, text: string) =>
  page.evaluate(
    ([called, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content!], called!));
      const event = new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true });
      document.body.dispatchEvent(event);
      return event.defaultPrevented;
    },
    [name, text],
  );

test('a project can be started from a file that exists already', async ({ workbench: page, server }) => {
  server.write('valley.tif', 'the old one');
  await terrainFile(page).setInputFiles(valley);
  await asked(page, 'valley.tif').getByRole('button', { name: 'Replace the file' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('valley');
  expect(readFileSync(join(server.folder, 'valley.tif')).equals(readFileSync(valley))).toBe(true);
  await toStartPage(page);

  await terrainFile(page).setInputFiles(valley);
  await asked(page, 'valley.tif').getByRole('button', { name: 'Close' }).click();
  await expect(asked(page, 'valley.tif')).toHaveCount(0);
  await expect(page.getByRole('heading', { name: 'New project' })).toBeVisible();
  await expect(page.getByText('Talus cannot read this file as terrain')).toHaveCount(0);
  // The same file again.
  await terrainFile(page).setInputFiles(valley);
  await asked(page, 'valley.tif').getByRole('button', { name: 'Use the existing file' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('valley');
  expect(await projectText(page)).toContain('raster = "valley.tif"');
});

const contours = JSON.stringify({
  type: 'FeatureCollection',
  crs: { type: 'name', properties: { name: 'EPSG:31287' } },
  features: [0, 10, 20].map((z) => ({
    type: 'Feature',
    properties: {},
    geometry: { type: 'LineString', coordinates: [[0, z, z], [50, z, z], [100, z, z]] }, // prettier-ignore
  })),
});

test('contours start a project as lines of a survey', async ({ workbench: page, server }) => {
  mkdirSync(join(server.folder, '.elsewhere'));
  const file = join(server.folder, '.elsewhere/contours.geojson');
  writeFileSync(file, contours);
  await terrainFile(page).setInputFiles(file);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('contours');
  await expect.poll(() => projectText(page)).toContain('lines = "contours.geojson"');
});

test('a setting names the .shp of an uploaded Shapefile', async ({ workbench: page, server }) => {
  server.write('a.toml', '[terrain]\npoints = "a.csv"\n');
  server.write('a.csv', 'x,y,z\n0,0,0\n10,0,0\n0,10,5\n');
  await page.reload();
  await openProject(page, 'a.toml');
  await openForm(page, /^Terrain/);
  const members = ['cpg', 'dbf', 'prj', 'shp', 'shx'].map((ending) => ({
    name: `contours.${ending}`,
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(ending),
  }));
  await page.getByLabel('Upload a file for Contours and breaklines').setInputFiles(members);
  await expect.poll(() => projectText(page)).toContain('lines = "contours.shp"');
  expect(server.read('contours.cpg')).toBe('cpg');
});

test('a truncated list of files is reported', async ({ workbench: page, server }) => {
  const cut = page.getByText('Only 2,000 files of the folder are listed.');
  await expect(page.getByRole('heading', { name: 'New project' })).toBeVisible();
  await expect(cut).toHaveCount(0);
  for (let k = 0; k <= 2000; ++k) server.write(`${k}.csv`, '');
  await page.reload();
  await expect(page.getByRole('region', { name: 'Projects in this folder' })).toContainText(/Only 2,000 files/);
  await page.getByRole('button', { name: 'Empty, 3D' }).click();
  await expect(cut).toBeVisible();
  await expect(page.getByText(/^and \d+ more, listed under their kinds$/)).toBeVisible();
  await page.getByRole('button', { name: /^Survey/ }).click();
  await expect(page.locator('.file-control').first()).toContainText('Only 2,000 files');
});

test('files can be dropped on every panel', async ({ workbench: page, server }) => {
  server.write('a.toml', 'name = "A"\n');
  await page.reload();
  await openProject(page, 'a.toml');
  await page.getByRole('tab', { name: 'Runs' }).click();
  expect(await drop(page, 'notes.txt2', 'x')).toBe(true);
  await expect(page.getByText('Uploaded: notes.txt2.')).toBeVisible();
  await page.getByRole('tab', { name: 'Text' }).click();
  expect(await drop(page, 'b.csv', 'x,y,z\n0,0,0\n10,0,0\n0,10,5\n')).toBe(true);
  await page.getByRole('dialog', { name: 'What is b.csv?' }).getByRole('button', { name: 'Survey (3D)' }).click();
  await expect(page.getByRole('heading', { name: 'Terrain', level: 2 })).toBeVisible();
  expect(await projectText(page)).toContain('points = "b.csv"');
});
