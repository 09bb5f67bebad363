// Sets equations for conf.py: reads {equation, isBlock} as JSON, one a line, and answers {html} or {problem}.
import { createInterface } from 'node:readline';
import katex from '../../web/node_modules/katex/dist/katex.mjs';

for await (const line of createInterface({ input: process.stdin })) {
  const { equation, isBlock } = JSON.parse(line);
  let answer;
  try {
    answer = { html: katex.renderToString(equation, { displayMode: isBlock, strict: 'error' }) };
  } catch (error) {
    answer = { problem: String(error) };
  }
  process.stdout.write(`${JSON.stringify(answer)}\n`);
}
