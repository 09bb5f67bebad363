// What a picture shows, by its pixels.

import type { Page } from '@playwright/test';

/// The middle of the view, over which nothing lies.
export async function viewShot(page: Page): Promise<Buffer> {
  const { x, y, width, height } = (await page.locator('.picture').boundingBox())!;
  const clip = { x: x + 0.25 * width, y: y + 60, width: 0.5 * width, height: height - 100 };
  return page.screenshot({ clip, animations: 'disabled' });
}
