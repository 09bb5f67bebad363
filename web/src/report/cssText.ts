/// A text as a string of CSS, whose other signs than letters, digits and those of plain texts are escaped.
export const cssText = (text: string) =>
  `"${text.replace(/[^\p{L}\p{N} .,:;+()/–·-]/gu, (sign) => `\\${sign.codePointAt(0)!.toString(16)} `)}"`;
