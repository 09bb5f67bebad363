// Divides typing in the text editor into steps for Undo.

const pause = 1000; // ms

let lastTyped = -Infinity;
let count = 0;

const linesOf = (text: string) => text.split('\n').length;

/// The step of a change. A step ends with a pause or with the line.
export function stepOf(before: string, after: string, now = performance.now()): string {
  if (now - lastTyped > pause || linesOf(before) !== linesOf(after)) ++count;
  lastTyped = now;
  return `text ${count}`;
}

/// The position in `after` where the change from `before` ends.
export function endOfChange(before: string, after: string): number {
  const shorter = Math.min(before.length, after.length);
  let first = 0;
  while (first < shorter && before[first] === after[first]) ++first;
  let last = 0;
  while (last < shorter - first && before.at(-1 - last) === after.at(-1 - last)) ++last;
  return after.length - last;
}
