// Scale bar and north arrow in the corners of a frame.

import type { Group, Side } from '../figures/plot';
import { amountIn, displayOf, givenLength, number } from './format';
import { roundLength } from './mapRoom';
import { paperName } from './run';
import type { Box } from './textBoxes';

export const scaleText = (denominator: number) => `Scale 1:${number(denominator)} on ${paperName}`;

// A round length in the displayed unit, up to a third of the frame; `scale`: drawing units per metre.
const lengthIn = ({ left, right }: Side, scale: number) =>
  roundLength(amountIn('m', (right - left) / scale / 3)) * displayOf('m').per;

export function drawScaleBar(group: Group, side: Side, scale: number) {
  const metres = lengthIn(side, scale);
  const [x, y, length] = [side.left + 12, side.bottom - 14, metres * scale];
  const bar = group.append('g').attr('class', 'scale-bar');
  const shape = `M${x},${y - 5}v5h${length}v-5`;
  bar.append('path').attr('class', 'halo').attr('d', shape);
  bar.append('path').attr('d', shape);
  const text = bar.append('text').attr('class', 'halo').attr('text-anchor', 'middle').text(givenLength(metres));
  text.attr('x', x + length / 2).attr('y', y - 5);
}

/// The map's y axis points up; it is north if the terrain has map coordinates.
export function drawNorthArrow(group: Group, { left, top }: Side, isNorth: boolean) {
  const arrow = group.append('g').attr('class', 'north').attr('transform', `translate(${left + 20},${top + 10})`);
  for (const name of ['halo', 'arrow']) arrow.append('path').attr('class', name).attr('d', 'M0,0l7,20l-7,-5l-7,5z');
  arrow.append('text').attr('class', 'halo').attr('y', 33).attr('text-anchor', 'middle').text(isNorth ? 'N' : 'y');
}

/// The room of both.
export const cornerBoxes = (side: Side, scale: number): Box[] => [
  [side.left + 8, side.bottom - 34, side.left + 20 + lengthIn(side, scale) * scale, side.bottom - 8],
  [side.left + 8, side.top + 6, side.left + 32, side.top + 48],
];
