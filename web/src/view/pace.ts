// How much detail frames have while a view moves. If all of it is drawn fast enough, as with a graphics card, a view has
// always all of it; otherwise less while anything moves, and all once it rests.

export interface Detail {
  /// Drawing buffer pixels along a side, as a share of those at rest.
  pixels: number;
  /// Cells of the terrain are about this much larger.
  cells: number;
  /// Of trajectories: the most segments, and how far they may be off [pixels].
  segments: number;
  tolerance: number;
}

export const atRest: Detail = { pixels: 1, cells: 1, segments: 400_000, tolerance: 0.4 };
const moving: readonly Detail[] = [
  { pixels: 1, cells: 4, segments: 60_000, tolerance: 0.8 },
  { pixels: 0.75, cells: 4, segments: 25_000, tolerance: 1.5 },
  { pixels: 0.6, cells: 8, segments: 12_000, tolerance: 2 },
  { pixels: 0.5, cells: 8, segments: 6_000, tolerance: 2.5 },
];

const [slow, rather, quick] = [90, 70, 35]; // ms of a frame: a tenth of a second is wanted
const quickFrames = 6; // in a row before there is more detail again

export class Pace {
  private step = 0;
  private isSlow = false;
  private quickOnes = 0;

  /// What a frame of a moving view has; null: as at rest.
  get moving(): Detail | null {
    return this.isSlow ? moving[this.step]! : null;
  }

  /// A frame with all detail took so long [ms].
  restTook(time: number) {
    if (time > slow && !this.isSlow) [this.isSlow, this.step] = [true, 1];
    if (time < rather) this.isSlow = false;
  }

  /// A frame of a moving view took so long [ms].
  movingTook(time: number) {
    this.quickOnes = time < quick ? this.quickOnes + 1 : 0;
    if (time > slow) this.step = Math.min(moving.length - 1, this.step + 1);
    else if (this.quickOnes >= quickFrames) [this.step, this.quickOnes] = [Math.max(0, this.step - 1), 0];
  }
}
