// The part of gifenc that is used, which comes without types.

declare module 'gifenc' {
  export type Colour = [number, number, number];
  export interface FrameOptions {
    /// Of the first frame: the palette of all that have none of their own.
    palette?: Colour[];
    transparent?: boolean;
    transparentIndex?: number;
    /// ms; rounded to hundredths of a second.
    delay?: number;
    /// 0: for ever; -1: the film is shown once.
    repeat?: number;
    /// 1: the frame stays, and the next one is drawn over it.
    dispose?: number;
  }
  export function GIFEncoder(): {
    writeFrame(index: Uint8Array, width: number, height: number, options: FrameOptions): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  };
  export function quantize(rgba: Uint8Array | Uint8ClampedArray, most: number): Colour[];
  export function applyPalette(rgba: Uint8Array | Uint8ClampedArray, palette: Colour[]): Uint8Array;
}
