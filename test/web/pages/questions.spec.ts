// The four questions of an engineer, asked after a run without collectors; a run with a collector there has the answers.

import type { Page } from '@playwright/test';
import { openProject } from '../support/steps';
import { rowsOf } from '../support/table';
import { expect, sources, test } from '../support/workbench';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const slope = readFileSync(join(sources, 'examples/tutorial-1/tutorial-1-3d.toml'), 'utf8').replace('rocks = 50', 'rocks = 400');
const withoutCollector = slope.slice(0, slope.indexOf('# Records rocks'));
const withCollector = `${slope.replace('height_m = 3.5', 'height_m = 20')}\n[design]\n`;

interface Answers {
  /// The numbers of the rocks that reached the collector.
  crossing: Set<string>;
  design: { percentiles: Record<string, Record<string, [number, number, number]>> };
}

/// Computes a project. Returns its run.
async function runOf(page: Page, file: string, text: string): Promise<string> {
  return page.evaluate(
    async ([file, text]) => {
      const headers = { 'Content-Type': 'application/json' };
      const begun = await fetch('/api/runs', { method: 'POST', headers, body: JSON.stringify({ file, text }) });
      const { id } = (await begun.json()) as { id: string };
      for (;;) {
        const { state } = (await (await fetch(`/api/runs/${id}`)).json()) as { state: string };
        if (state === 'done') return id;
        await new Promise((resolve) => setTimeout(resolve, 100));
      }
    },
    [file, text] as const,
  );
}

const fileOf = (page: Page, run: string, name: string): Promise<string> =>
  page.evaluate(async (path) => (await fetch(path)).text(), `/api/runs/${run}/files/${name}`);

async function answersOf(page: Page, run: string): Promise<Answers> {
  const hits = rowsOf(await fileOf(page, run, 'barriers.csv'));
  const { design } = JSON.parse(await fileOf(page, run, 'summary.json')) as { design: { lines: Answers['design'][] } };
  return { crossing: new Set(hits.map(({ rock }) => rock!)), design: design.lines[0]! };
}

test('the four questions are answered as by collectors', async ({ workbench: page, server }) => {
  server.write('slope.toml', withoutCollector);
  await page.reload();
  const higher = withCollector.replaceAll(/(tangential_restitution = \{ mean = )0\.9/g, '$10.99');
  const { crossing, design } = await answersOf(page, await runOf(page, 'collector.toml', withCollector));
  const { crossing: crossingThen } = await answersOf(page, await runOf(page, 'higher.toml', higher));

  await openProject(page, 'slope.toml');
  await page.keyboard.press('Control+Enter');
  await page.getByRole('button', { name: 'Ask a line', exact: true }).click();
  const card = page.getByRole('region', { name: 'Ask a line' });
  await card.getByText('Points, x and y [m]').click();
  for (const [k, [x, y]] of [['15', '0'], ['15', '50']].entries()) {
    await card.getByRole('textbox', { name: `x, row ${k + 1}`, exact: true }).fill(x!);
    await card.getByRole('textbox', { name: `y, row ${k + 1}`, exact: true }).fill(y!);
    await card.getByRole('textbox', { name: `y, row ${k + 1}`, exact: true }).press('Tab');
  }

  // Which share crosses?
  const share = card.locator('.big-share').first();
  await expect(share).toContainText(`cross: ${crossing.size} of 400 rocks`, { timeout: 60_000 });

  // With which energy and height?
  const figure = (title: string) => card.locator('.asked-figures > div').filter({ hasText: title }).locator('dd strong');
  const number = async (title: string) => Number((await figure(title).textContent())!.replace(/[^\d.]/g, ''));
  expect(await number('95 % translational energy')).toBeCloseTo(Number((design.percentiles.ke_translational_J!['95']![0] / 1000).toPrecision(3)), 6);
  expect(await number("95 % height of the block's top")).toBeCloseTo(Number(design.percentiles.height_m!['95']![0].toPrecision(3)), 6);

  // Where do they come from? All from the one place of release; the filter leaves as many as crossed.
  await expect(card.locator('.asked-sources li button')).toHaveText(new RegExp(`Crest, x [\\d.]+, y [\\d.]+ m: ${crossing.size} of 400 rocks, `));
  await card.getByLabel('Only rocks that cross').check();
  await page.getByRole('tab', { name: 'Overview' }).click();
  await expect(page.locator('.results .filter-note')).toContainText(`${crossing.size} of 400 rocks: cross the asked line`);

  // What if the restitution is 10 % higher?
  await card.getByRole('button', { name: 'Vary the inputs', exact: true }).click();
  const row = card.locator('.what-if-table tr').filter({ hasText: 'Tangential restitution +10 %' });
  await expect(row).toBeVisible({ timeout: 60_000 });
  // The table shows the rocks so far: the difference of all comes last.
  const change = async () => Number(/[+−-]?[\d.]+/.exec((await row.locator('td').textContent())!)![0].replace('−', '-'));
  await expect.poll(change, { timeout: 60_000 }).toBeCloseTo((100 * (crossingThen.size - crossing.size)) / 400, 1);
});
