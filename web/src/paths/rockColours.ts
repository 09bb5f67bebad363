// The colours of a colouring for canvases, in few shades, so that pieces of one colour are drawn together.

import { colourAt, cssOf, restColour } from '../view/colours';
import type { Colouring } from './colouring';

const shades = 48; // number of colours of a scale

/// The index of each point's colour, and the colours.
export function colourNumbers(colouring: Colouring): { of: (point: number, rock: number) => number; css: string[] } {
  if (colouring.kind === 'run') return { of: () => 0, css: [colouring.colour] };
  if (colouring.kind === 'kinds') return { of: (_, rock) => colouring.numbers[rock]!, css: colouring.colours };
  const { values, low, high, ramp } = colouring;
  const css = Array.from({ length: shades }, (_, k) => cssOf(colourAt(ramp, k / (shades - 1))));
  const of = (point: number) => {
    const share = (values[point]! - low) / (high - low || 1);
    return Number.isNaN(share) ? 0 : Math.max(0, Math.min(shades - 1, Math.round(share * (shades - 1))));
  };
  return { of, css };
}

/// The colour of a rock at a point of its trajectory; null: at its end point.
export function rockColours(colouring: Colouring): (point: number | null, rock: number) => string {
  const { of, css } = colourNumbers(colouring);
  return (point, rock) => (point === null && colouring.kind === 'scale' ? restColour : css[of(point ?? 0, rock)]!);
}
