// Pixels of places in the views, by the coordinates that the status line shows.

import { expect, type Page } from '@playwright/test';

type Place = [number, number];

/// The coordinates under the pointer: x and z of a section, x and y of a terrain; null: none.
async function placeUnder(page: Page, [x, y]: Place): Promise<Place | null> {
  await page.mouse.move(x, y);
  const status = page.locator('.status-line .mono');
  await expect(status).toBeVisible();
  await page.waitForTimeout(60); // until the next frame
  const found = /x (-?[\d.]+) [yz] (-?[\d.]+)/.exec((await status.textContent()) ?? '');
  return found && [Number(found[1]), Number(found[2])];
}

/// The point of the window at which a view shows a place.
export async function pixelOf(page: Page, place: Place): Promise<Place> {
  const { x, y, width, height } = (await page.locator('.picture').boundingBox())!;
  let at: Place = [x + width / 2, y + height / 2];
  for (let turn = 0; turn < 6; ++turn) {
    const [here, right, below] = [
      (await placeUnder(page, at))!,
      (await placeUnder(page, [at[0] + 20, at[1]]))!,
      (await placeUnder(page, [at[0], at[1] + 20]))!,
    ];
    // The coordinates are nearly linear in the pixels.
    const [a, b, c, d] = [right[0] - here[0], below[0] - here[0], right[1] - here[1], below[1] - here[1]].map((change) => change / 20) as [number, number, number, number];
    const [dx, dy] = [place[0] - here[0], place[1] - here[1]];
    const determinant = a * d - b * c;
    const step: Place = [(d * dx - b * dy) / determinant, (a * dy - c * dx) / determinant];
    at = [at[0] + step[0], at[1] + step[1]];
    if (Math.hypot(...step) < 0.7) return at;
  }
  return at;
}

/// Drags from one point of the window to another. `during` is called before the button is released.
export async function drag(page: Page, from: Place, to: Place, during: () => Promise<void> = async () => undefined) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 3 });
  await page.mouse.move(...to, { steps: 3 });
  await during();
  await page.mouse.up();
}
