// Equations in LaTeX, set with the fonts of KaTeX.

import katex from 'katex';
import 'katex/dist/katex.min.css';

/// HTML of an equation, on a line of its own (`isBlock`) or within text. Throws if it is not valid.
export function setEquation(equation: string, isBlock: boolean): string {
  return katex.renderToString(equation, { displayMode: isBlock, strict: 'error' });
}
