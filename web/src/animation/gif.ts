// Animated GIFs (GIF89a). All frames share one palette, and a frame holds only the pixels that have changed: the ground
// and the trajectories behind the rocks stay as they are, without flicker and at little cost.

import { applyPalette, GIFEncoder, quantize, type Colour } from 'gifenc';

type Pixels = Uint8ClampedArray;

const mostColours = 255; // and one for pixels that stay

/// Every pixel of a few frames, or evenly spread ones of large frames.
function sampleOf(frames: readonly Pixels[]): Uint8Array {
  const most = 400_000; // pixels; more hardly change the palette
  const all = frames.reduce((sum, frame) => sum + frame.length / 4, 0);
  const step = Math.max(1, Math.ceil(all / most));
  const sample: number[] = [];
  for (const frame of frames)
    for (let at = 0; at < frame.length; at += 4 * step) sample.push(frame[at]!, frame[at + 1]!, frame[at + 2]!, 255);
  return Uint8Array.from(sample);
}

export class Gif {
  private readonly encoder = GIFEncoder();
  private readonly colours: Colour[];
  private before: Uint8Array | null = null;

  /// `typical`: frames that have the colours of all others.
  constructor(
    private readonly width: number,
    private readonly height: number,
    typical: readonly Pixels[],
  ) {
    this.colours = quantize(sampleOf(typical), mostColours);
  }

  /// Adds a frame, red, green, blue and opacity of each pixel, which is shown for `delay` ms.
  add(frame: Pixels, delay: number) {
    const now = applyPalette(frame, this.colours);
    const stays = this.colours.length;
    const { before } = this;
    const drawn = before ? now.map((colour, k) => (before[k] === colour ? stays : colour)) : now;
    this.encoder.writeFrame(drawn, this.width, this.height, {
      ...(before ? {} : { palette: [...this.colours, [0, 0, 0] as Colour] }),
      transparent: before !== null,
      transparentIndex: stays,
      delay,
      dispose: 1,
    });
    this.before = now;
  }

  finish(): Uint8Array<ArrayBuffer> {
    this.encoder.finish();
    return this.encoder.bytes();
  }
}
