// Converts line ends between a file and a text area, which only has \n.

export const asTyped = (text: string) => text.replace(/\r\n?/g, '\n');

/// The position in the text of a position in the text area.
function placeIn(text: string, typedPlace: number): number {
  let at = 0;
  for (let k = 0; k < typedPlace; ++k) at += text.startsWith('\r\n', at) ? 2 : 1;
  return at;
}

/// The text changed to what the text area contains. Existing line ends are kept; new ones are like the first.
export function withTyped(text: string, typed: string): string {
  if (!text.includes('\r')) return typed;
  const before = asTyped(text);
  const shorter = Math.min(before.length, typed.length);
  let first = 0;
  while (first < shorter && before[first] === typed[first]) ++first;
  let last = 0;
  while (last < shorter - first && before.at(-1 - last) === typed.at(-1 - last)) ++last;
  const lineEnd = /\r\n?|\n/.exec(text)?.[0] ?? '\n';
  const piece = typed.slice(first, typed.length - last).replaceAll('\n', lineEnd);
  return text.slice(0, placeIn(text, first)) + piece + text.slice(placeIn(text, before.length - last));
}
