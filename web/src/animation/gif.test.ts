import { describe, expect, it } from 'vitest';
import { Gif } from './gif';

const [width, height] = [40, 20];

/// A white picture with a red square, whose left side is at `left`.
function square(left: number): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray(4 * width * height).fill(255);
  for (let y = 5; y < 15; ++y) for (let x = left; x < left + 10; ++x) pixels.set([200, 0, 0, 255], 4 * (y * width + x));
  return pixels;
}

/// The blocks of a GIF89a file.
function read(bytes: Uint8Array) {
  const word = (at: number) => bytes[at]! + 256 * bytes[at + 1]!;
  const text = (from: number, to: number) => String.fromCharCode(...bytes.subarray(from, to));
  const colours = 2 << (bytes[10]! & 7);
  let at = 13 + (bytes[10]! & 0x80 ? 3 * colours : 0);
  const frames: { delay: number; transparent: number | null; bytes: number; hasPalette: boolean }[] = [];
  let control = { delay: 0, transparent: null as number | null };
  const skip = () => {
    const begin = at;
    while (bytes[at] !== 0) at += bytes[at]! + 1;
    ++at;
    return at - begin;
  };
  while (bytes[at] !== 0x3b) {
    if (bytes[at] === 0x21) {
      if (bytes[at + 1] === 0xf9) control = { delay: word(at + 4), transparent: bytes[at + 3]! & 1 ? bytes[at + 6]! : null };
      at += 2;
      skip();
    } else {
      const hasPalette = (bytes[at + 9]! & 0x80) !== 0;
      at += 10 + 1;
      frames.push({ ...control, bytes: skip(), hasPalette });
    }
  }
  return { head: text(0, 6), width: word(6), height: word(8), frames, end: at + 1 };
}

describe('Gif', () => {
  it('has a palette for all frames, delays, and pixels that stay', () => {
    const gif = new Gif(width, height, [square(0), square(20)]);
    gif.add(square(0), 40);
    gif.add(square(20), 40);
    gif.add(square(20), 2000);
    const bytes = gif.finish();
    const { head, frames, end, ...size } = read(bytes);
    expect([head, size.width, size.height, end]).toEqual(['GIF89a', width, height, bytes.length]);
    expect(frames.map(({ delay }) => delay)).toEqual([4, 4, 200]);
    expect(frames.map(({ hasPalette }) => hasPalette)).toEqual([false, false, false]);
    expect(frames[0]!.transparent).toBe(null);
    expect(frames[1]!.transparent).toBe(frames[2]!.transparent);
    expect(frames[1]!.transparent).not.toBe(null);
    // A frame in which nothing moves has one colour, and is shorter than any other.
    expect(frames[2]!.bytes).toBeLessThan(frames[1]!.bytes);
  });

  it('gives the same bytes for the same frames', () => {
    const made = () => {
      const gif = new Gif(width, height, [square(0), square(20)]);
      for (let left = 0; left < 30; left += 5) gif.add(square(left), 50);
      return gif.finish();
    };
    expect(made()).toEqual(made());
  });
});
