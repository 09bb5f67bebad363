// A browser has six connections to a server: more tabs still work and receive all events.

import { expect, test } from '../support/workbench';

test('eight tabs are notified of a run, also when the first is closed', async ({ workbench: page, server }) => {
  server.copyExample('tutorial-1');
  const address = new URL('/', page.url()).href;
  const tabs = [];
  for (let k = 0; k < 7; ++k) {
    const tab = await page.context().newPage();
    await tab.goto(address);
    await tab.getByRole('button', { name: /tutorial-1-2d\.toml/ }).first().click();
    await tab.getByRole('tab', { name: 'Runs' }).click();
    tabs.push(tab);
  }
  const last = tabs.at(-1)!;
  await last.getByRole('button', { name: 'Compute', exact: true }).first().click();
  for (const tab of tabs) await expect(tab.locator('li.run')).toContainText('Done');
  await page.close();
  await last.getByRole('button', { name: 'Compute', exact: true }).click();
  for (const tab of tabs) await expect(tab.locator('li.run')).toHaveCount(2);
});
