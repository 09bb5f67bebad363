// Frames a second, time to the first picture and memory of the workbench's page, in Chromium without a graphics card:
// node bench/page.mjs [PROGRAM] [CASE ...], after a build and the tests of the page, which install Playwright.
// PROGRAM is build/talus if it is not given; cases: small, rocks, mesh, raster; all if none is given.
//
// `rocks` needs a run of about ten seconds, `mesh` and `raster` have five million triangles. Frames are those that the
// page asks the browser for; it waits for the graphics. Numbers compare only on a machine that does nothing else.

import { createHash } from 'node:crypto';
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { addressOf } from './served.mjs';

const sources = resolve(import.meta.dirname, '..');
const { chromium } = createRequire(join(sources, 'test/web/package.json'))('@playwright/test');
const program = resolve(process.argv[2] ?? join(sources, 'build/talus'));
const names = process.argv.slice(3);

const nodes = 1583; // a side: five million triangles
const height = (i, j) => 300 - 0.15 * j + 12 * Math.sin(i / 40) * Math.cos(j / 55) + 1.5 * Math.sin(i / 3.1) * Math.sin(j / 2.7);
const materials = '[[material]]\nname = "Rock"\nlike = "bedrock_outcrops"\n';
const seeder = '[[seeder]]\ntype = "point"\nposition = [800, 200, "surface"]\nrocks = 20\nmass_kg = 1000\n';

function writeMesh(folder) {
  const faces = 2 * (nodes - 1) ** 2;
  const head = `ply\nformat binary_little_endian 1.0\nelement vertex ${nodes * nodes}\nproperty float x\nproperty float y\nproperty float z\nelement face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`;
  const bytes = Buffer.alloc(head.length + 12 * nodes * nodes + 13 * faces);
  let at = bytes.write(head, 'latin1');
  for (let j = 0; j < nodes; ++j)
    for (let i = 0; i < nodes; ++i) {
      // Moved off the grid, so that the mesh has no rows.
      at = bytes.writeFloatLE(i + 0.3 * Math.sin(12.9 * i + 78.2 * j), at);
      at = bytes.writeFloatLE(j + 0.3 * Math.sin(39.3 * i + 11.1 * j), at);
      at = bytes.writeFloatLE(height(i, j), at);
    }
  const face = (...corners) => {
    at = bytes.writeUInt8(3, at);
    for (const corner of corners) at = bytes.writeInt32LE(corner, at);
  };
  for (let j = 0; j + 1 < nodes; ++j)
    for (let i = 0; i + 1 < nodes; ++i) {
      const k = j * nodes + i;
      face(k, k + 1, k + nodes + 1);
      face(k, k + nodes + 1, k + nodes);
    }
  writeFileSync(join(folder, 'big.ply'), bytes);
  writeFileSync(join(folder, 'mesh.toml'), `[terrain]\nmesh = "big.ply"\n${materials}${seeder}`);
}

function writeRaster(folder) {
  const rows = Array.from({ length: nodes }, (_, r) => Array.from({ length: nodes }, (_, i) => height(i, nodes - 1 - r).toFixed(2)).join(' '));
  writeFileSync(join(folder, 'big.asc'), `ncols ${nodes}\nnrows ${nodes}\nxllcenter 0\nyllcenter 0\ncellsize 1\n${rows.join('\n')}\n`);
  writeFileSync(join(folder, 'raster.toml'), `[terrain]\nraster = "big.asc"\n${materials}${seeder}`);
}

function writeRocks(folder) {
  for (const name of ['valley.tif', 'cliffs.geojson']) cpSync(join(sources, 'examples/first-gis-run', name), join(folder, name));
  const text = readFileSync(join(sources, 'examples/first-gis-run/first-gis-run.toml'), 'utf8');
  writeFileSync(join(folder, 'rocks.toml'), `${text.replace('rocks_per_cell = 5', 'rocks_per_cell = 6')}[output]\npaths = "all"\n`);
}

const writeSmall = (folder) => cpSync(join(sources, 'examples/tutorial-1/tutorial-1-3d.toml'), join(folder, 'small.toml'));

const cases = {
  small: { write: writeSmall, runs: true },
  rocks: { write: writeRocks, runs: true },
  mesh: { write: writeMesh },
  raster: { write: writeRaster },
};

/// In the page: counts frames, and bytes that are given to the graphics.
function watch() {
  const sizes = new Map();
  window.graphicsBytes = () => [...sizes.values()].reduce((sum, size) => sum + size, 0);
  const gl = WebGL2RenderingContext.prototype;
  const wrap = (name, note) => {
    const own = gl[name];
    gl[name] = function (...values) {
      note.call(this, ...values);
      return own.apply(this, values);
    };
  };
  const bound = { 34962: 34964, 34963: 34965 };
  wrap('bufferData', function (target, data) {
    if (bound[target]) sizes.set(this.getParameter(bound[target]), typeof data === 'number' ? data : data.byteLength);
  });
  wrap('deleteBuffer', (buffer) => sizes.delete(buffer));
  wrap('texStorage2D', function (target, levels, format, width, height) {
    const each = { 34836: 16, 33340: 8, 36214: 8, 36208: 16 }[format] ?? 4;
    if (target === 3553) sizes.set(this.getParameter(32873), each * width * height);
  });
  wrap('deleteTexture', (texture) => sizes.delete(texture));
  window.frames_ = { count: 0, since: 0 };
  const tick = () => {
    ++window.frames_.count;
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

const rate = (page, task) =>
  page
    .evaluate(() => ([window.frames_.count, window.frames_.since] = [0, performance.now()]))
    .then(task)
    .then(() => page.evaluate(() => (1000 * window.frames_.count) / (performance.now() - window.frames_.since)));

async function orbit(page, seconds) {
  const { x, y, width, height: high } = await page.locator('.picture canvas').first().boundingBox();
  const [across, down] = [x + width / 2, y + high / 2];
  await page.mouse.move(across, down);
  await page.mouse.down();
  const turn = async () => {
    const begun = Date.now();
    for (let s = 0; s < seconds; s = (Date.now() - begun) / 1000) {
      await page.mouse.move(across + 200 * Math.sin(s), down + 40 * Math.sin(2 * s));
      await page.waitForTimeout(10);
    }
  };
  await turn(); // until the detail has adapted
  const frames = await rate(page, turn);
  await page.mouse.up();
  return frames;
}

/// Towards the ground in the middle of the view, until its finest tiles are drawn.
async function approach(page) {
  const { x, y, width, height: high } = await page.locator('.picture canvas').first().boundingBox();
  await page.mouse.move(x + width / 2, y + high / 2);
  for (let k = 0; k < 14; ++k) {
    await page.mouse.wheel(0, -240);
    await page.waitForTimeout(300);
  }
  await page.waitForTimeout(20_000); // the server makes each level of a mesh when it is first asked for
}

async function memory(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage');
  const graphics = await page.evaluate(() => window.graphicsBytes());
  return [usedSize + backingStorageSize, graphics].map((bytes) => (bytes / 1e6).toFixed(0));
}

async function measure(name, { write, runs = false }) {
  const folder = mkdtempSync(join(tmpdir(), 'talus-bench-page-'));
  write(folder);
  const text = readFileSync(join(folder, `${name}.toml`));
  const server = spawn(program, ['serve', folder, '--port', '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-gpu-compositing', ...(process.getuid() === 0 ? ['--no-sandbox'] : [])],
  });
  try {
    const address = await addressOf(server);
    const page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
    page.setDefaultTimeout(300_000);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.addInitScript(watch);
    let received = 0;
    const session = await page.context().newCDPSession(page);
    await session.send('Network.enable');
    const data = new Set();
    session.on('Network.responseReceived', ({ requestId, response }) => /\/(tiles\/|mesh$|paths)/.test(response.url) && data.add(requestId));
    session.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => data.has(requestId) && (received += encodedDataLength));
    await page.goto(address);
    const begun = performance.now();
    await page.getByRole('button', { name: new RegExp(`${name}.toml`) }).first().click();
    await page.getByRole('button', { name: 'Distance' }).waitFor();
    await page.getByText('Loading the terrain').waitFor({ state: 'hidden' });
    const picture = (performance.now() - begun) / 1000;
    if (runs) {
      await page.keyboard.press('Control+Enter');
      await page.getByRole('group', { name: 'Playback' }).waitFor();
    }
    await page.waitForTimeout(5000);
    const hash = createHash('sha256').update(text).digest('hex').slice(0, 16);
    console.log(`${name}: project ${hash}`);
    console.log(`  first picture after ${picture.toFixed(1)} s`);
    console.log(`  orbiting: ${(await orbit(page, 5)).toFixed(1)} frames/s`);
    if (!runs) {
      await approach(page);
      if (process.env.SHOTS) await page.screenshot({ path: join(process.env.SHOTS, `${name}-near.png`) });
      console.log(`  orbiting near the ground: ${(await orbit(page, 5)).toFixed(1)} frames/s`);
    }
    if (runs) {
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      console.log(`  playing: ${(await rate(page, () => page.waitForTimeout(5000))).toFixed(1)} frames/s`);
    }
    const [heap, graphics] = await memory(page);
    console.log(`  memory of the page: ${heap} MB, and ${graphics} MB of graphics; ${(received / 1e6).toFixed(1)} MB of terrain and trajectories received`);
  } finally {
    await browser.close();
    server.kill();
    rmSync(folder, { recursive: true, force: true });
  }
}

for (const [name, each] of Object.entries(cases)) if (names.length === 0 || names.includes(name)) await measure(name, each);
