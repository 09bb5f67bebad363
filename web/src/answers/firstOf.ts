// Lists that must fit on a page.

/// The first ones, and how many are left out and where they are.
export const firstOf = (texts: readonly string[], most: number, where: string): string[] =>
  texts.length > most ? [...texts.slice(0, most - 1), `and ${(texts.length - most + 1).toLocaleString('en')} more, ${where}`] : [...texts];
