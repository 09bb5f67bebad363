import katex from 'katex';
import { describe, expect, test } from 'vitest';
import { documents, textOf } from './documents';
import { equationOptions } from './equation';
import { blocksOf, sectionOf, spansOf } from './markdown';
import { topics } from './topics';

describe('blocks', () => {
  test('headings, paragraphs of several lines, code', () =>
    expect(blocksOf('# A `b`\n\nOne\ntwo.\n\n```\na  b\n\nc\n```\nthree')).toEqual([
      { kind: 'heading', level: 1, text: 'A `b`' },
      { kind: 'paragraph', text: 'One two.' },
      { kind: 'code', text: 'a  b\n\nc' },
      { kind: 'paragraph', text: 'three' },
    ]));
  test('lists with items of several lines', () =>
    expect(blocksOf('Say:\n- one\n  more\n- two\n\n1. first\n2. second')).toEqual([
      { kind: 'paragraph', text: 'Say:' },
      { kind: 'list', ordered: false, items: ['one more', 'two'] },
      { kind: 'list', ordered: true, items: ['first', 'second'] },
    ]));
  test('tables', () =>
    expect(blocksOf('| a | b |\n| --- | --- |\n| 1 | |\n')).toEqual([
      { kind: 'table', head: ['a', 'b'], rows: [['1', '']] },
    ]));
  test('bars in tables', () =>
    expect(blocksOf('| a |\n| --- |\n| \\|x\\| |\n')).toEqual([{ kind: 'table', head: ['a'], rows: [['|x|']] }]));
  test('equations', () => expect(blocksOf('```math\na = b\n```')).toEqual([{ kind: 'equation', text: 'a = b' }]));
  test('comments are left out', () => expect(blocksOf('<!-- a\nb -->\nc')).toEqual([{ kind: 'paragraph', text: 'c' }]));
});

test('spans', () =>
  expect(spansOf('a `b*c*` **d** *e* [f](g.md) 2 * 3 $`h_i`$')).toEqual([
    { kind: 'text', text: 'a ' },
    { kind: 'code', text: 'b*c*' },
    { kind: 'text', text: ' ' },
    { kind: 'strong', text: 'd' },
    { kind: 'text', text: ' ' },
    { kind: 'emphasis', text: 'e' },
    { kind: 'text', text: ' ' },
    { kind: 'link', text: 'f', to: 'g.md' },
    { kind: 'text', text: ' 2 * 3 ' },
    { kind: 'equation', text: 'h_i' },
  ]));

test('a section ends at the next heading of its level', () => {
  const blocks = blocksOf('# A\n\n## B\n\nb\n\n### C\n\nc\n\n## D\n\nd');
  expect(sectionOf(blocks, 'B').map((block) => ('text' in block ? block.text : ''))).toEqual(['B', 'b', 'C', 'c']);
  expect(sectionOf(blocks, 'none')).toHaveLength(blocks.length);
});

test('the documents contain every help topic', async () => {
  for (const { document, heading } of topics) {
    const headings = blocksOf(await textOf(document)).filter(({ kind }) => kind === 'heading');
    expect(headings.map((block) => (block as { text: string }).text)).toContain(heading);
  }
});

test('every equation of the documents is valid', async () => {
  const texts = (await Promise.all(documents.map(textOf))).join('\n');
  const equations = [...texts.matchAll(/^```math\n([^]*?)^```|\$`([^`]+)`\$/gm)].map((found) => found[1] ?? found[2]!);
  expect(equations.length).toBeGreaterThan(50);
  for (const equation of equations) expect(katex.renderToString(equation, equationOptions(true))).toContain('katex-html');
});

test('a picture is left out', () => expect(blocksOf('One.\n\n![A view](view.png)\n\nTwo.').map((block) => 'text' in block && block.text)).toEqual(['One.', 'Two.']));
