import { expect, test } from 'vitest';
import { drawAxes, type Look } from './drawGround';

const frame = { width: 900, height: 400, x: 50, z: 20, along: 8, up: 8 };
const look: Look = { text: '', faint: '', line: '', panel: '', ground: '', accent: '' };

/// The numbers of x and their axis label, above a strip of this height along the lower edge.
function numbersAbove(strip: number) {
  const words: string[] = [];
  const pen = { measureText: (text: string) => ({ width: 6 * text.length }), strokeText: () => {}, fillText: (text: string) => words.push(text) };
  const top = frame.height - strip;
  const boxes = drawAxes(pen as unknown as CanvasRenderingContext2D, frame, look, [{ left: -6, top, right: frame.width + 6, bottom: frame.height + 6 }]);
  return { words, lowest: Math.max(...boxes.map(({ bottom }) => bottom)), top };
}

test('the axis of x is above the status strip, also while that has the hint of a tool', () => {
  for (const strip of [32, 52]) {
    const { words, lowest, top } = numbersAbove(strip);
    for (const word of ['0', '20', '80', 'x, m', 'z, m']) expect(words).toContain(word);
    expect(lowest).toBeLessThanOrEqual(top);
  }
});
