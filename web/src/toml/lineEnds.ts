// Line ends between a file and a field of text, which knows only those of Unix.

export const asTyped = (text: string) => text.replace(/\r\n?/g, '\n');

/// Where the character of a field stands in the text.
function placeIn(text: string, typedPlace: number): number {
  let at = 0;
  for (let k = 0; k < typedPlace; ++k) at += text.startsWith('\r\n', at) ? 2 : 1;
  return at;
}

/// The text with what was typed into the field; line ends stay as they were, and new ones are like the first.
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
