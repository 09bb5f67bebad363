// Boxes of marks and names on a map, which are to keep clear of each other.

export type Box = [left: number, top: number, right: number, bottom: number];
export type Anchor = 'start' | 'middle' | 'end';

const letterWidth = 7.2;

export function boxOfText(text: string, anchor: Anchor, x: number, y: number): Box {
  const width = letterWidth * text.length;
  const left = { start: x, middle: x - width / 2, end: x - width }[anchor];
  return [left, y - 12, left + width, y + 4];
}

const touches = (a: Box, b: Box) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
export const isFree = (box: Box, taken: readonly Box[]) => !taken.some((other) => touches(box, other));
