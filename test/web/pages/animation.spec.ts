// The playback saved as an animated GIF, and the title block in the form.

import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { openExample, openForm, projectText, fillField } from '../support/steps';
import { expect, test } from '../support/workbench';

/// Size, number of frames and duration [s] of a GIF89a file.
function readGif(bytes: Buffer) {
  let at = 13 + (bytes[10]! & 0x80 ? 3 * (2 << (bytes[10]! & 7)) : 0);
  let [frames, hundredths] = [0, 0];
  const skip = () => {
    while (bytes[at] !== 0) at += bytes[at]! + 1;
    ++at;
  };
  while (bytes[at] !== 0x3b) {
    if (bytes[at] === 0x21) {
      if (bytes[at + 1] === 0xf9) hundredths += bytes.readUInt16LE(at + 4);
      at += 2;
    } else {
      ++frames;
      at += 11;
    }
    skip();
  }
  return { kind: bytes.toString('latin1', 0, 6), width: bytes.readUInt16LE(6), height: bytes.readUInt16LE(8), frames, seconds: hundredths / 100 };
}

/// The share of pixels that differ by more than a little between two frames of a GIF, and of dark ones in its heading.
const compare = (page: Page, bytes: Buffer, one: number, other: number) =>
  page.evaluate(
    async ([text, one, other]) => {
      const data = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const decoder = new ImageDecoder({ data, type: 'image/gif' });
      const pixels = async (frameIndex: number) => {
        const { image } = await decoder.decode({ frameIndex });
        const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
        const pen = canvas.getContext('2d', { willReadFrequently: true })!;
        pen.drawImage(image, 0, 0);
        return { all: pen.getImageData(0, 0, canvas.width, canvas.height).data, width: canvas.width };
      };
      await decoder.tracks.ready;
      const [a, b] = [await pixels(one), await pixels(other)];
      let [changed, dark] = [0, 0];
      for (let k = 0; k < a.all.length; k += 4) {
        if ([0, 1, 2].some((c) => Math.abs(a.all[k + c]! - b.all[k + c]!) > 24)) ++changed;
        if (k / 4 < 36 * a.width && a.all[k]! < 90) ++dark;
      }
      return { changed: changed / (a.all.length / 4), dark };
    },
    [bytes.toString('base64'), one, other] as const,
  );

for (const [title, what] of [
  ['Tutorial 1, a section', 'a section'],
  ['Tutorial 1, in 3D', 'a scene'],
] as const)
  test(`the rocks of ${what} are saved as an animation`, async ({ workbench: page }) => {
    test.setTimeout(180_000);
    await openExample(page, title);
    await page.getByRole('button', { name: 'Animation', exact: true }).click();
    const dialog = page.getByRole('dialog', { name: 'Save the animation' });
    await dialog.getByLabel('Duration').fill('1');
    await dialog.getByLabel('Frames per second').selectOption('10');
    await dialog.getByLabel('Size').selectOption('640 × 360');
    await expect(dialog).toContainText('11 frames');
    const [download] = await Promise.all([page.waitForEvent('download', { timeout: 120_000 }), dialog.getByRole('button', { name: 'Save' }).click()]);
    expect(download.suggestedFilename()).toMatch(/\.gif$/);
    const bytes = readFileSync(await download.path());
    expect(readGif(bytes)).toEqual({ kind: 'GIF89a', width: 640, height: 360, frames: 11, seconds: 3 });
    const { changed, dark } = await compare(page, bytes, 2, 6);
    expect(changed).toBeGreaterThan(0.0005); // the rocks move,
    expect(changed).toBeLessThan(0.2); // and the ground stays
    expect(dark).toBeGreaterThan(100); // the title
    await expect(page.getByRole('dialog')).toHaveCount(0);
  });

test('an animation is cancelled', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  const slider = page.getByRole('slider', { name: 'Time' });
  const before = await slider.inputValue();
  await page.getByRole('button', { name: 'Animation', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Save the animation' });
  await dialog.getByLabel('Duration').fill('0');
  await expect(dialog.getByRole('button', { name: 'Save' })).toBeDisabled();
  await dialog.getByLabel('Duration').fill('50');
  let saved = false;
  page.on('download', () => (saved = true));
  await dialog.getByRole('button', { name: 'Save' }).click();
  const making = page.getByRole('dialog', { name: 'Saving the animation' });
  await expect(making).toContainText(/Frame [1-9]\d* of 1001/);
  await making.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByRole('dialog')).toHaveCount(0);
  await expect(slider).toHaveValue(before);
  expect(saved).toBe(false);
});

test('the title block is a form', async ({ workbench: page }) => {
  await openExample(page, 'Tutorial 1, a section');
  await openForm(page, /^Title block of the report/);
  await fillField(page, 'Client', 'Bergheim');
  await page.getByLabel('Paper', { exact: true }).selectOption('A3');
  await page.getByRole('button', { name: '‹ Model' }).click();
  await expect(page.getByRole('navigation', { name: 'Model' }).getByRole('button', { name: /^Title block of the report/ })).toContainText('A3');
  expect(await projectText(page)).toMatch(/\[report\]\nclient = "Bergheim"\npaper = "A3"/);
});
