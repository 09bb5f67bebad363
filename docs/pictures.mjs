// Renews the pictures of the documentation and of the start page: node docs/pictures.mjs [PROGRAM], after a build and the
// tests of the page, which install Playwright. It needs pdftoppm, of Debian's poppler-utils. PROGRAM is build/talus if it
// is not given.

import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { addressOf } from '../bench/served.mjs';

const sources = resolve(import.meta.dirname, '..');
const program = resolve(process.argv[2] ?? join(sources, 'build/talus'));
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

/// The same rocks under each rock model.
async function pictureOfModels(browser, folder) {
  const project = join(sources, 'examples/models/road.toml');
  execFileSync(program, ['compare', project, '--models', '--quiet', '-o', join(folder, 'models')]);
  const page = await browser.newPage({ viewport: { width: 1240, height: 1900 } });
  await page.goto(`file://${folder}/models/compare.html`);
  await page.addStyleTag({ content: '.columns { grid-template-columns: repeat(3, minmax(0, 1fr)) !important } .save, #paths h2 { display: none }' });
  const clip = await page.locator('#paths').boundingBox();
  await page.screenshot({ path: join(sources, 'docs/which-model.png'), clip });
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
  await pictureOfReport(browser, folder);
  await pictureOfModels(browser, folder);
  await pictureOfWorkbench(browser, folder);
  await picturesOfExamples(browser, folder);
  await pictureOfValidation(browser, folder);
  pictureOfSheet(folder);
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
