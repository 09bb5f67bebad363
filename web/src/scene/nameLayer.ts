// Names of seeders and barriers, on a canvas over the scene.

import type { Vector3 } from 'three';
import { drawLabels, labelOf, placeLabels } from '../view/labels';
import type { Box } from '../geometry/framing';
import { cssColour } from '../view/theme';
import type { Stage } from './stage';

export interface Name {
  text: string;
  /// In the scene's coordinates.
  at: Vector3;
  /// The colour of a plate behind it.
  plate?: string;
}

/// Draws names in CSS pixels of the stage, outside the boxes `over`.
export function drawNames(pen: CanvasRenderingContext2D, stage: Stage, names: readonly Name[], over: readonly Box[]) {
  const { width, height } = stage.size;
  const labels = names.flatMap(({ text, at, plate }) => {
    const pixel = stage.pixelOf(at);
    return pixel ? [labelOf(pen, text, [pixel.x, pixel.y], 6, plate)] : [];
  });
  const placed = placeLabels(labels, { left: 4, top: 4, right: width - 4, bottom: height - 4 }, over);
  drawLabels(pen, placed, { text: cssColour('--text'), halo: cssColour('--panel') });
}

export class NameLayer {
  private readonly canvas = document.createElement('canvas');

  constructor(host: HTMLElement) {
    this.canvas.className = 'names';
    host.append(this.canvas);
  }

  draw(stage: Stage, names: readonly Name[], over: readonly Box[]) {
    const { width, height } = stage.size;
    const scale = Math.min(devicePixelRatio, 2);
    const size = { width: Math.round(width * scale), height: Math.round(height * scale) };
    if (this.canvas.width !== size.width || this.canvas.height !== size.height) Object.assign(this.canvas, size);
    const pen = this.canvas.getContext('2d');
    if (!pen) return;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, width, height);
    drawNames(pen, stage, names, over);
  }
}
