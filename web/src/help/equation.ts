// Equations in LaTeX, set with the fonts of KaTeX.

import katex from 'katex';
import 'katex/dist/katex.min.css';

/// Of an equation on a line of its own (`isBlock`) or within text. One that is not valid is refused.
export const equationOptions = (isBlock: boolean) => ({ displayMode: isBlock, strict: 'error' as const });

/// Sets an equation in an element. Throws if it is not valid.
export const drawEquation = (place: HTMLElement, equation: string, isBlock: boolean) =>
  katex.render(equation, place, equationOptions(isBlock));
