// Screenshots of the views.

import { expect, type Page } from '@playwright/test';

/// The central part of the view, which no control covers, with all its detail.
export async function viewShot(page: Page): Promise<Buffer> {
  await expect(page.locator('canvas[data-detail="less"]')).toHaveCount(0);
  const { x, y, width, height } = (await page.locator('.picture').boundingBox())!;
  const clip = { x: x + 0.25 * width, y: y + 60, width: 0.5 * width, height: height - 100 };
  return page.screenshot({ clip, animations: 'disabled' });
}

/// The view once two screenshots in a row are equal, when everything is drawn.
export async function stillShot(page: Page): Promise<Buffer> {
  let last = await viewShot(page);
  const isStill = async () => {
    const before = last;
    last = await viewShot(page);
    return last.equals(before);
  };
  await expect.poll(isStill).toBe(true);
  return last;
}
