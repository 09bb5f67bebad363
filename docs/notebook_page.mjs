// A notebook as a page: its cells with the outputs that it stores.

import { readFileSync } from 'node:fs';

const escaped = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
const joined = (text) => [text ?? ''].flat().join('');

/// Strings, comments and words of Python in colours.
const coloured = (code) =>
  escaped(code).replace(/("[^"\n]*")|(#.*)|\b(import|for|in|from|as|if|else|return|lambda)\b/g, (all, string, comment) =>
    `<span class="${string ? 'string' : comment ? 'comment' : 'word'}">${all}</span>`,
  );

/// Headings and paragraphs are all that the notebooks have.
const prose = (text) =>
  text
    .split(/\n\n+/)
    .map((part) => {
      const heading = /^(#+) (.*)/.exec(part);
      return heading ? `<h${heading[1].length}>${escaped(heading[2])}</h${heading[1].length}>` : `<p>${escaped(part)}</p>`;
    })
    .join('');

function output({ text, data = {} }) {
  if (data['image/png']) return `<img src="data:image/png;base64,${joined(data['image/png'])}">`;
  return data['text/html'] ? joined(data['text/html']) : `<pre>${escaped(joined(text) || joined(data['text/plain']))}</pre>`;
}

const style = `body { font: 15px/1.45 sans-serif; color: #1b2430; width: 800px; margin: 0 auto; padding: 8px 24px }
pre { font: 13px/1.4 monospace; margin: 6px 0; white-space: pre-wrap } .code { background: #f5f7f9; border: 1px solid #d5dbe1; padding: 4px 12px }
.string { color: #a11 } .comment { color: #5c6875 } .word { color: #1f5fa8; font-weight: 600 }
table { border-collapse: collapse } td { padding: 2px 14px 2px 0 } td:first-child { color: #5c6875 } img { max-width: 720px }`;

/// The first `count` cells of a notebook.
export function notebookPage(file, count) {
  const cells = JSON.parse(readFileSync(file, 'utf8')).cells.slice(0, count);
  const body = cells.map((cell) =>
    cell.cell_type === 'code'
      ? `<pre class="code">${coloured(joined(cell.source))}</pre>${cell.outputs.map(output).join('')}`
      : prose(joined(cell.source)),
  );
  return `<!doctype html><meta charset="utf-8"><style>${style}</style><main>${body.join('\n')}</main>`;
}
