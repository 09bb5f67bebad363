// Renews the pictures of the documentation and of the start page: node docs/pictures.mjs [PICTURE ...], after a build and
// the tests of the page, which install Playwright. It needs pdftoppm, of Debian's poppler-utils. The program is
// build/talus, or what TALUS_PROGRAM names; without pictures all are renewed.

import { execFileSync, spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { addressOf } from '../bench/served.mjs';
import { notebookPage } from './notebook_page.mjs';

const sources = resolve(import.meta.dirname, '..');
const program = resolve(process.env.TALUS_PROGRAM ?? join(sources, 'build/talus'));
const { chromium } = createRequire(join(sources, 'test/web/package.json'))('@playwright/test');

/// The beginning of the report of Tutorial 1, down to its first figure.
async function pictureOfReport(browser, folder) {
  const project = join(sources, 'examples/tutorial-1/tutorial-1-2d.toml');
  execFileSync(program, ['run', project, '--quiet', '-o', join(folder, 'tutorial-1-2d')]);
  const page = await browser.newPage({ viewport: { width: 1000, height: 1100 } });
  await page.goto(`file://${folder}/tutorial-1-2d/report.html`);
  const figure = await page.locator('figure').first().boundingBox();
  const height = Math.round(figure.y + figure.height + 24);
  await page.screenshot({ path: join(sources, 'docs/tutorial-1.png'), clip: { x: 0, y: 0, width: 1000, height } });
}

/// A part of a page that a command has written, with a margin.
async function pictureOfPage(browser, file, { part, style = '', width = 1140, name }) {
  const page = await browser.newPage({ viewport: { width, height: 2400 } });
  await page.goto(`file://${file}`);
  if (style) await page.addStyleTag({ content: style });
  const boxes = await Promise.all((await page.locator(part).all()).map((each) => each.boundingBox()));
  const [left, top] = [Math.min(...boxes.map(({ x }) => x)), Math.min(...boxes.map(({ y }) => y))];
  const right = Math.max(...boxes.map((box) => box.x + box.width));
  const bottom = Math.max(...boxes.map((box) => box.y + box.height));
  const clip = { x: left - 8, y: top - 8, width: right - left + 16, height: bottom - top + 16 };
  await page.screenshot({ path: join(sources, 'docs', name), clip, fullPage: true, timeout: 120_000 });
  await page.close();
}

/// Without the buttons that save a figure.
const plain = '.save { display: none }';

/// The same rocks under each rock model.
async function pictureOfModels(browser, folder) {
  execFileSync(program, ['compare', join(sources, 'examples/models/road.toml'), '--models', '--quiet', '-o', join(folder, 'models')]);
  const style = `${plain} .columns { grid-template-columns: repeat(3, minmax(0, 1fr)) !important } #paths h2 { display: none }`;
  await pictureOfPage(browser, join(folder, 'models/compare.html'), { part: '#paths', style, name: 'which-model.png' });
}

/// Where along the rim of a crater a fence catches the rocks that would reach the path.
async function pictureOfDesign(browser, folder) {
  execFileSync(program, ['run', join(sources, 'examples/maungawhau/barrier-design.toml'), '--quiet', '-o', join(folder, 'design')]);
  await pictureOfPage(browser, join(folder, 'design/report.html'), { part: '#design figure >> nth=0', style: plain, name: 'gallery-design.png' });
}

/// What a hazard map is made from: how strong rocks are, and which share of them arrives.
async function pictureOfMaps(browser, folder) {
  execFileSync(program, ['run', join(sources, 'examples/maungawhau/maungawhau.toml'), '--quiet', '-o', join(folder, 'map')]);
  const style = `${plain} #maps figure { display: none } #maps figure:is(:nth-of-type(2), :nth-of-type(4)) { display: block }`;
  await pictureOfPage(browser, join(folder, 'map/report.html'), { part: '#maps figure:visible', style, name: 'gallery-maps.png' });
}

/// A map of a region, of the energy that 95 % of the rocks in a cell have at most, merged from four shards.
async function pictureOfRegion(browser, folder) {
  const [region, shards, merged] = ['region', 'shards', 'merged'].map((name) => join(folder, name));
  execFileSync('/usr/bin/python3', [join(sources, 'bench/hundred_million_cells.py'), '--write', region, '--side', '4000', '--rocks', '100000']);
  for (const k of [1, 2, 3, 4])
    execFileSync(program, ['run', join(region, 'run.toml'), '--quiet', '--shard', `${k}/4`, '-o', join(shards, `${k}`)]);
  execFileSync(program, ['merge', shards, '-o', merged], { stdio: 'ignore' });
  const style = `${plain} .release { display: none } .figure-head { visibility: hidden } .columns { display: block !important } #maps svg { width: 680px; height: auto }`;
  await pictureOfPage(browser, join(merged, 'report.html'), { part: '#maps figure >> nth=1 >> svg', style, name: 'gallery-region.png' });
}

/// What thirty blocks on a slope say of the ground.
async function pictureOfCalibration(browser, folder) {
  execFileSync(program, ['calibrate', join(sources, 'examples/calibration/study.toml'), '--quiet', '-o', join(folder, 'ground')], { stdio: 'ignore' });
  // Two parameters, and how far rocks run.
  const style = `${plain} #main > * { display: none } #parameters, #predictions { display: contents !important } :is(#parameters, #predictions) > :not(.columns) { display: none }
    .columns { display: contents !important } #main { display: grid; grid-template-columns: repeat(3, 1fr); gap: 24px } body { max-width: none }
    #parameters figure:nth-of-type(n + 3) { display: none }`;
  await pictureOfPage(browser, join(folder, 'ground/report.html'), { part: 'figure:visible', style, width: 1260, name: 'gallery-calibration.png' });
}

/// The beginning of a notebook, as it is stored.
async function pictureOfNotebook(browser, folder) {
  const file = join(folder, 'notebook.html');
  writeFileSync(file, notebookPage(join(sources, 'examples/notebooks/line.ipynb'), 7));
  await pictureOfPage(browser, file, { part: 'main', name: 'gallery-notebook.png' });
}

/// Starts the workbench, and passes its page to a task.
async function inWorkbench(browser, folder, task) {
  const server = spawn(program, ['serve', folder, '--port', '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
  try {
    const address = await addressOf(server);
    const page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.goto(address);
    await task(page);
    await page.close();
  } finally {
    server.kill();
  }
}

/// The workbench with the rocks of Tutorial 1 half way down.
const pictureOfWorkbench = (browser, folder) =>
  inWorkbench(browser, folder, async (page) => {
    await page.getByRole('button', { name: /^Tutorial 1, in 3D/ }).click();
    await page.getByRole('group', { name: 'Playback' }).waitFor();
    await page.getByRole('tab', { name: 'Barriers' }).click();
    await page.getByRole('slider', { name: 'Time', exact: true }).fill('2.9');
    await page.getByRole('img', { name: /^Histogram/ }).waitFor();
    await page.mouse.move(683, 340);
    await page.waitForTimeout(3000); // until the view is drawn
    await page.screenshot({ path: join(sources, 'docs/workbench.png') });
  });

/// Boulders that tumble down the flank of a crater: the scene alone, in the whole window.
const pictureOfBoulders = (browser, folder) => {
  const project = join(folder, 'boulders');
  cpSync(join(sources, 'examples/maungawhau'), project, { recursive: true });
  return inWorkbench(browser, project, async (page) => {
    await page.setViewportSize({ width: 1600, height: 860 });
    await page.getByRole('button', { name: 'boulders.toml' }).click();
    await page.getByRole('button', { name: /^Compute/ }).first().click();
    await page.getByRole('group', { name: 'Playback' }).waitFor({ timeout: 120_000 });
    await page.addStyleTag({ content: '.scene { position: fixed; z-index: 1000 } .view-bar, .compass { display: none !important }' });
    // The eye, and the point that it looks at.
    await page.evaluate((address) => { location.hash = address; }, '#/boulders.toml?view=330,-52,150,397,95,149');
    await page.getByRole('slider', { name: 'Time', exact: true }).fill('6.6');
    await page.waitForTimeout(5000); // until the view is drawn
    await page.screenshot({ path: join(sources, 'docs/boulders.png') });
  });
};

/// The pictures of the examples on the start page: those that the workbench saves when a project is closed.
const picturesOfExamples = (browser, folder) =>
  inWorkbench(browser, folder, async (page) => {
    const { examples } = await (await page.request.get(new URL('/api/examples', page.url()).href)).json();
    mkdirSync(join(sources, 'web/public/examples'), { recursive: true });
    for (const { id, title, file } of examples) {
      await page.getByRole('region', { name: 'Try an example' }).getByRole('button', { name: title, exact: false }).first().click();
      await page.getByRole('group', { name: 'Playback' }).waitFor({ timeout: 120_000 });
      await page.waitForTimeout(3000); // until the view is drawn
      const saved = page.waitForResponse((response) => response.request().method() === 'PUT' && response.url().includes('/api/pictures/'));
      await page.getByRole('button', { name: 'Start page' }).click();
      await saved;
      await page.getByRole('region', { name: 'Try an example' }).waitFor();
      const picture = await page.request.get(new URL(`/api/pictures/${file}`, page.url()).href);
      if (!picture.ok()) throw new Error(`${file} has no picture`);
      writeFileSync(join(sources, 'web/public/examples', `${id}.webp`), await picture.body());
    }
  });

/// The predictions of half A of the meadow at Tschamut by the first model.
async function pictureOfValidation(browser, folder) {
  execFileSync(program, ['validate', 'tschamut2014', '--quiet', '-o', folder], { stdio: 'ignore' });
  await pictureOfPage(browser, join(folder, 'tschamut2014/report.html'), { part: '.columns >> nth=0 >> figure:not(figure ~ figure ~ figure)', style: plain, name: 'validation.png' });
}

/// The first sheet of a run over terrain, as printed on A3.
function pictureOfSheet(folder) {
  const [out, pdf] = [join(folder, 'maungawhau'), join(folder, 'sheet.pdf')];
  execFileSync(program, ['run', join(sources, 'examples/maungawhau/maungawhau.toml'), '--quiet', '-o', out]);
  const titleBlock = {
    client: 'City of Auckland',
    project: 'Maungawhau, crater path',
    number: '2026-117',
    author: 'A. Meier',
    checked: 'B. Rossi',
    revision: 'A',
    text: 'An example, for no real purpose',
    paper: 'A3',
  };
  const settings = Object.entries(titleBlock).flatMap(([key, value]) => ['--set', `report.${key}=${value}`]);
  execFileSync(program, ['report', out, '--pdf', pdf, ...settings]);
  execFileSync('pdftoppm', ['-png', '-r', '75', '-singlefile', pdf, join(sources, 'docs/sheet')]);
}

const pictures = {
  report: pictureOfReport,
  models: pictureOfModels,
  design: pictureOfDesign,
  maps: pictureOfMaps,
  region: pictureOfRegion,
  calibration: pictureOfCalibration,
  notebook: pictureOfNotebook,
  workbench: pictureOfWorkbench,
  boulders: pictureOfBoulders,
  examples: picturesOfExamples,
  validation: pictureOfValidation,
  sheet: (_, folder) => pictureOfSheet(folder),
};
const chosen = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(pictures);
for (const name of chosen) if (!pictures[name]) throw new Error(`there is no picture ${name}; there are ${Object.keys(pictures).join(', ')}`);

const folder = mkdtempSync(join(tmpdir(), 'talus-pictures-'));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: [
    '--use-gl=angle',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    ...(process.getuid() === 0 ? ['--no-sandbox'] : []),
  ],
});
try {
  for (const name of chosen) await pictures[name](browser, folder);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
