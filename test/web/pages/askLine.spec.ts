// Asking a line: the numbers of its card are those of a collector there, it follows drags, and its release places filter.

import type { Page, Request } from '@playwright/test';
import { findings } from '../support/findings';
import { openExample, projectText, toStartPage } from '../support/steps';
import { expect, test } from '../support/workbench';

const card = (page: Page) => page.getByRole('region', { name: 'Ask a line' });
const share = (page: Page) => card(page).locator('.big-share').first();
const figure = (page: Page, title: string) => card(page).locator('.asked-figures > div').filter({ hasText: title }).locator('dd');
const openCard = (page: Page) => page.getByRole('button', { name: 'Ask a line', exact: true }).click();
const isAsked = (request: Request) => request.method() === 'POST' && /\/api\/runs\/[^/]+\/line$/.test(request.url());

async function typeLine(page: Page, points: readonly (readonly [number, number])[]) {
  const cell = (column: string, row: number) => card(page).getByRole('textbox', { name: `${column}, row ${row}`, exact: true });
  if (!(await cell('x', 1).isVisible())) await card(page).getByText('Points, x and y [m]').click();
  for (const [k, [x, y]] of points.entries()) {
    await cell('x', k + 1).fill(String(x));
    await cell('y', k + 1).fill(String(y));
    await cell('y', k + 1).press('Tab');
  }
}

const runId = (page: Page): Promise<string> => page.evaluate(async () => (await (await fetch('/api/runs')).json()).runs[0].id);
/// The answer of the server to a question.
async function answerTo(page: Page, question: object) {
  return page.evaluate(
    async ([id, body]) => {
      const request = { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
      return (await fetch(`/api/runs/${id}/line`, request)).json();
    },
    [await runId(page), question] as const,
  );
}

const line = [[15, 0], [15, 50]] as const; // that of the example's collector

test('a line counts the rocks of a collector there, below its top or above', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await openCard(page);
  await typeLine(page, line);
  const { barriers } = await page.evaluate(async (id) => (await fetch(`/api/runs/${id}/barriers`)).json(), await runId(page));
  const crossing = barriers[0].rocks_hit + barriers[0].passed_above;
  expect(crossing).toBeGreaterThan(10);
  await expect(share(page)).toContainText(`${(2 * crossing).toFixed(1)} % cross: ${crossing} of 50 rocks`);
  const typed = await card(page).locator('.asked-figures').textContent();
  // The collector itself has the same numbers.
  await card(page).getByLabel('Barrier or collector').selectOption('Line at 15 m');
  await expect(card(page).getByLabel('Barrier or collector')).toHaveValue('Line at 15 m');
  await expect(share(page)).toContainText(`${crossing} of 50 rocks`);
  await expect(card(page).locator('.asked-figures')).toHaveText(typed!);
  // With few rocks the intervals say so, and the number that would do is offered.
  await expect(card(page).getByRole('button', { name: /^Run [\d,]+ rocks$/ })).toBeVisible();
});

test('the numbers are those of the design of a run', async ({ workbench: page }) => {
  await openExample(page, 'A barrier, designed');
  const { design } = await page.evaluate(async (id) => (await fetch(`/api/runs/${id}/summary`)).json(), await runId(page));
  const halfWay = design.lines.find(({ name }: { name: string }) => name === 'Half way');
  await openCard(page);
  const begun = Date.now();
  await typeLine(page, [[250, 70], [330, 65], [450, 70]]);
  await expect(share(page)).toContainText(`${Number(halfWay.rocks).toLocaleString('en')} of 20,000 rocks`);
  expect(Date.now() - begun).toBeLessThan(20_000);
  const three = (value: number) => Number(value.toPrecision(3)).toLocaleString('en', { maximumFractionDigits: 9 });
  await expect(figure(page, "95 % height of the block's top")).toContainText(`${three(halfWay.percentiles.height_m['95'][0])} m`);
  await expect(figure(page, '95 % velocity')).toContainText(`${three(halfWay.percentiles.velocity_m_s['95'][0])} m/s`);
  await expect(figure(page, '95 % translational energy')).toContainText(`${three(halfWay.percentiles.ke_translational_J['95'][0] / 1000)} kJ`);
  await expect(figure(page, '95 % total energy')).toContainText(`${three(halfWay.percentiles.ke_total_J['95'][0] / 1000)} kJ`);
  await expect(share(page)).toContainText('from sampling alone, with 95 % confidence');
  if (halfWay.needs) await expect(figure(page, 'class by UNI 11211-4')).toContainText(String(halfWay.needs.class ?? 'none'));
  await expect(card(page).getByText(/^A fence needs most energy.* from \d+ to \d+ m/)).toBeVisible();
  await expect(card(page).locator('.asked-profile rect.worst').first()).toBeAttached();

  // The sentence of the sliders is an entry of the answer's table.
  const { kits } = await answerTo(page, { line: [[250, 70], [330, 65], [450, 70]] });
  const [height, capacity] = [card(page).getByRole('slider', { name: 'Height' }), card(page).getByRole('slider', { name: 'Capacity' })];
  await height.fill('2');
  await capacity.fill('1');
  const percent = (value: number) => (100 * value).toFixed(1).replace(/\.0$/, '');
  const sentence = `${kits.heights_m[2]} m and ${kits.energies_kJ[1].toLocaleString('en')} kJ here stop ${percent(kits.share[2][1])} %`;
  await expect(card(page).locator('.kit-sentence')).toContainText(sentence);

  expect(await findings(page, '.ask-card')).toEqual([]);
});

test('corners and the line are dragged; Escape ends a drag, Undo takes it back', async ({ workbench: page }) => {
  await openExample(page, 'Maungawhau');
  const picture = page.getByRole('application', { name: /Model in three dimensions/ });
  const { width } = (await picture.boundingBox())!;
  await openCard(page);
  await expect.poll(async () => (await picture.boundingBox())!.width).toBeLessThan(width); // the card takes its room
  await picture.focus();
  await picture.press('2'); // plan
  await picture.press('8'); // of the whole model, on whose ground the line is drawn
  await card(page).getByRole('button', { name: 'Draw a line' }).click();
  await expect(page.getByText('Click along the line that is asked.')).toBeVisible();
  const box = (await picture.boundingBox())!;
  const [left, right] = [
    [box.x + 0.45 * box.width, box.y + 0.8 * box.height],
    [box.x + 0.57 * box.width, box.y + 0.8 * box.height],
  ] as const;
  await page.mouse.click(...left);
  await page.mouse.click(...right);
  let asked = page.waitForRequest(isAsked);
  await page.keyboard.press('Enter');
  const drawn = (await asked).postDataJSON().line as [number, number][];
  expect(drawn).toHaveLength(2);
  await expect(share(page)).toBeVisible();
  const before = await share(page).textContent();

  const dragLeft = async (end: () => Promise<void>) => {
    await page.mouse.move(...left);
    await page.mouse.down();
    await page.mouse.move(left[0], left[1] - 30, { steps: 5 });
    await page.mouse.move(left[0], left[1] - 60, { steps: 5 });
    await end();
  };
  await card(page).getByText('Points, x and y [m]').click();
  const y = card(page).getByRole('textbox', { name: 'y, row 1', exact: true });
  await dragLeft(() => page.mouse.up());
  await expect.poll(async () => Number(await y.inputValue())).toBeGreaterThan(drawn[0]![1] + 20);
  const dragged = await y.inputValue();
  await expect(card(page).getByRole('textbox', { name: 'y, row 2', exact: true })).toHaveValue(String(drawn[1]![1]));

  asked = page.waitForRequest(isAsked);
  await page.keyboard.press('Control+z');
  expect((await asked).postDataJSON().line).toEqual(drawn);
  await expect(share(page)).toHaveText(before!);
  await page.keyboard.press('Control+y');
  await expect(y).toHaveValue(dragged);
  await page.keyboard.press('Control+z');
  await expect(y).toHaveValue(String(drawn[0]![1]));

  await dragLeft(() => page.keyboard.press('Escape'));
  await page.mouse.up();
  await expect(y).toHaveValue(String(drawn[0]![1]));
  await expect(card(page)).toBeVisible();

  // The whole line: both corners move by the same.
  const middle = [(left[0] + right[0]) / 2, left[1]] as const;
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0], middle[1] - 25, { steps: 6 });
  await page.mouse.up();
  await expect.poll(async () => Number(await y.inputValue())).toBeGreaterThan(drawn[0]![1]);
  const up = Number(await y.inputValue()) - drawn[0]![1];
  const other = Number(await card(page).getByRole('textbox', { name: 'y, row 2', exact: true }).inputValue()) - drawn[1]![1];
  expect(Math.abs(up - other)).toBeLessThan(0.02);
});

test('a release place leaves only its rocks, in the tables and the trajectories', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await openCard(page);
  await card(page).getByRole('button', { name: 'Draw an area' }).click();
  await page.keyboard.press('Escape');
  await typeLine(page, [[15, 0], [15, 50]]);
  const places = card(page).locator('.asked-sources li button');
  await expect(places.first()).toBeVisible();
  const [, count, of] = /: ([\d,]+) of ([\d,]+) rocks?, /.exec((await places.first().textContent())!)!;
  expect(Number(count)).toBeLessThanOrEqual(Number(of));
  await places.first().click();
  await page.getByRole('tab', { name: 'Overview' }).click();
  const note = page.locator('.results .filter-note');
  await expect(note).toContainText(`${of} of 50 rocks: from release place`);
  await expect(page.locator('summary').filter({ hasText: 'Filter: ' })).toBeVisible(); // of the trajectories, too
  await card(page).getByLabel('Only rocks that cross').check();
  await expect(note).toContainText(`${count} of 50 rocks`);
  // Again: the rocks of all places that cross.
  await places.first().click();
  const crossing = /: ([\d,]+) of 50 rocks/.exec((await share(page).textContent())!)![1];
  await expect(note).toContainText(`${crossing} of 50 rocks: cross the asked line`);
  await note.getByRole('button', { name: 'All rocks' }).click();
  await expect(card(page).getByLabel('Only rocks that cross')).not.toBeChecked();
});

test('a collector is put at the line as one step of Undo; lines are read from files, and kept', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, in 3D');
  await openCard(page);
  const input = card(page).getByLabel('File with a line');
  await input.setInputFiles({ name: 'road.csv', mimeType: 'text/csv', buffer: Buffer.from('x_m,y_m\n15,5\n15,45\n') });
  await expect(share(page)).toContainText('of 50 rocks');
  const before = await projectText(page);
  await card(page).getByRole('button', { name: 'Put a collector here' }).click();
  const after = await projectText(page);
  expect(after.replace(before.trimEnd(), '')).toContain('line = [[15, 5], [15, 45]]');
  expect(after).toContain('[[collector]]\nname = "Collector 1"');
  await page.keyboard.press('Control+z');
  expect(await projectText(page)).toBe(before);

  const feature = { type: 'Feature', properties: {}, geometry: { type: 'Polygon', coordinates: [[[10, 5], [20, 5], [20, 45], [10, 45], [10, 5]]] } };
  await input.setInputFiles({ name: 'fan.geojson', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({ type: 'FeatureCollection', crs: { type: 'name', properties: { name: 'EPSG:2056' } }, features: [feature] })) });
  await expect(share(page)).toContainText(/% enter: \d+/);
  const asked = await share(page).textContent();
  await toStartPage(page);
  await openExample(page, 'Tutorial 1, in 3D');
  await expect(share(page)).toHaveText(asked!);
  await page.keyboard.press('Control+z'); // opened again: nothing to undo
  await expect(share(page)).toHaveText(asked!);
  await card(page).getByRole('button', { name: 'Close' }).click();
  await expect(card(page)).toBeHidden();
  await page.goBack();
  await expect(card(page)).toBeVisible();
  await input.setInputFiles({ name: 'none.csv', mimeType: 'text/csv', buffer: Buffer.from('a,b\n') });
  await expect(page.getByText('none.csv has no line: it needs two or more rows, with x and y in metres in the first two columns.')).toBeVisible();
});

test('a place of a section is asked', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openCard(page);
  await card(page).getByText('Place, x [m]').click();
  const x = card(page).getByRole('textbox', { name: 'x, row 1', exact: true });
  await x.fill('15');
  await x.press('Tab');
  await expect(share(page)).toContainText('of 50 rocks');
});
