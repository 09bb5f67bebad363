// Renews the pictures of the documentation and of the start page: node docs/pictures.mjs [PICTURE ...], after a build and
// the tests of the page, which install Playwright. It needs pdftoppm, of Debian's poppler-utils. The program is
// build/talus, or what TALUS_PROGRAM names; without pictures all are renewed.

import { execFileSync, spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { addressOf } from '../bench/served.mjs';

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
  await page.screenshot({ path: join(sources, 'docs', name), clip, fullPage: true });
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

/// The map of the 95th percentile of bounce heights.
async function pictureOfMap(browser, folder) {
  execFileSync(program, ['run', join(sources, 'examples/maungawhau/maungawhau.toml'), '--quiet', '-o', join(folder, 'map')]);
  await pictureOfPage(browser, join(folder, 'map/report.html'), { part: '#maps figure >> nth=0', style: plain, name: 'gallery-map.png' });
}

/// What thirty blocks on a slope say of the ground.
async function pictureOfCalibration(browser, folder) {
  execFileSync(program, ['calibrate', join(sources, 'examples/calibration/study.toml'), '--quiet', '-o', join(folder, 'ground')], { stdio: 'ignore' });
  await pictureOfPage(browser, join(folder, 'ground/report.html'), { part: 'figure >> nth=0', style: plain, name: 'gallery-calibration.png' });
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

/// Blocks of four shapes that tumble down a slope.
const pictureOfBlocks = (browser, folder) => {
  const project = join(folder, 'blocks');
  mkdirSync(project, { recursive: true });
  cpSync(join(sources, 'examples/blocks/blocks.toml'), join(project, 'blocks.toml'));
  return inWorkbench(browser, project, async (page) => {
    await page.getByRole('button', { name: /blocks/i }).first().click();
    await page.getByRole('button', { name: /^Compute/ }).first().click();
    await page.getByRole('group', { name: 'Playback' }).waitFor({ timeout: 120_000 });
    await page.getByRole('slider', { name: 'Time', exact: true }).fill('6');
    await page.waitForTimeout(5000); // until the view is drawn
    await page.screenshot({ path: join(sources, 'docs/gallery-blocks.png') });
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
  const page = await browser.newPage({ viewport: { width: 1140, height: 900 } });
  await page.goto(`file://${folder}/tschamut2014/report.html`);
  const first = await page.locator('figure').nth(0).boundingBox();
  const second = await page.locator('figure').nth(1).boundingBox();
  const clip = {
    x: first.x - 8,
    y: first.y - 8,
    width: second.x + second.width - first.x + 16,
    height: Math.max(first.height, second.height) + 16,
  };
  await page.screenshot({ path: join(sources, 'docs/validation.png'), clip, fullPage: true });
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
  map: pictureOfMap,
  calibration: pictureOfCalibration,
  workbench: pictureOfWorkbench,
  blocks: pictureOfBlocks,
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
