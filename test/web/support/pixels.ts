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

export type Rgb = [number, number, number];

/// The number of pixels of the view near each colour.
export async function pixelsLike(page: Page, colours: Rgb[], near = 40): Promise<number[]> {
  const picture = await page.locator('.picture canvas').first().screenshot();
  // On a separate page: the workbench's security policy forbids data URLs.
  const reader = await page.context().newPage();
  const counts = await reader.evaluate(
    async ([bytes, wanted, most]) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${bytes}`)).blob());
      const pen = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, image.width, image.height);
      return wanted.map(([r, g, b]) => {
        let found = 0;
        for (let k = 0; k < data.length; k += 4)
          if (Math.hypot(data[k]! - r, data[k + 1]! - g, data[k + 2]! - b) < most) ++found;
        return found;
      });
    },
    [picture.toString('base64'), colours, near] as const,
  );
  await reader.close();
  return counts;
}
