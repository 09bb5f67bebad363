// The subset of Markdown that the documentation of Talus uses. Equations are LaTeX, in a block ```math or inline as
// $`...`$.

export type Block =
  | { kind: 'heading'; level: number; text: string }
  | { kind: 'paragraph'; text: string }
  | { kind: 'list'; ordered: boolean; items: string[] }
  | { kind: 'table'; head: string[]; rows: string[][] }
  | { kind: 'code'; text: string }
  | { kind: 'equation'; text: string };

export type Span =
  | { kind: 'text' | 'code' | 'strong' | 'emphasis' | 'equation'; text: string }
  | { kind: 'link'; text: string; to: string };

const cells = (line: string) =>
  line
    .replace(/^\||\|\s*$/g, '')
    .split(/(?<!\\)\|/)
    .map((cell) => cell.trim().replaceAll('\\|', '|'));

const item = /^(-|\d+\.) +/;

export function blocksOf(markdown: string): Block[] {
  const lines = markdown.replace(/<!--[\s\S]*?-->/g, '').split('\n');
  const blocks: Block[] = [];
  let k = 0;
  const take = (while_: (line: string) => boolean): string[] => {
    const taken: string[] = [];
    while (k < lines.length && while_(lines[k]!)) taken.push(lines[k++]!);
    return taken;
  };
  while (k < lines.length) {
    const line = lines[k]!;
    const heading = /^(#+) +(.*)$/.exec(line);
    if (line.trim() === '') ++k;
    else if (heading) {
      blocks.push({ kind: 'heading', level: heading[1]!.length, text: heading[2]! });
      ++k;
    } else if (line.startsWith('```')) {
      ++k;
      const kind = line === '```math' ? 'equation' : 'code';
      blocks.push({ kind, text: take((next) => !next.startsWith('```')).join('\n') });
      ++k;
    } else if (line.startsWith('|')) {
      const [head, , ...rows] = take((next) => next.startsWith('|'));
      blocks.push({ kind: 'table', head: cells(head!), rows: rows.map(cells) });
    } else if (item.test(line)) {
      const items: string[] = [];
      for (const next of take((more) => item.test(more) || /^\s+\S/.test(more))) {
        if (item.test(next)) items.push(next.replace(item, ''));
        else items[items.length - 1] += ` ${next.trim()}`;
      }
      blocks.push({ kind: 'list', ordered: /^\d/.test(line), items });
    } else {
      const text = take((next) => next.trim() !== '' && !/^(#+ |```|\|)/.test(next) && !item.test(next));
      // Pictures are on the site alone.
      if (!line.startsWith('![')) blocks.push({ kind: 'paragraph', text: text.map((part) => part.trim()).join(' ') });
    }
  }
  return blocks;
}

/// The blocks of the section with this heading, including the heading; all blocks if there is no such heading.
export function sectionOf(blocks: readonly Block[], heading: string): Block[] {
  const start = blocks.findIndex((block) => block.kind === 'heading' && block.text === heading);
  if (start < 0) return [...blocks];
  const { level } = blocks[start] as { level: number };
  const length = blocks.slice(start + 1).findIndex((block) => block.kind === 'heading' && block.level <= level);
  return blocks.slice(start, length < 0 ? undefined : start + 1 + length);
}

const marks = /\$`([^`]+)`\$|`([^`]+)`|\*\*([^*]+)\*\*|\*([^*\s][^*]*)\*|\[([^\]]+)\]\(([^)]+)\)/g;

export function spansOf(text: string): Span[] {
  const spans: Span[] = [];
  let at = 0;
  for (const found of text.matchAll(marks)) {
    if (found.index > at) spans.push({ kind: 'text', text: text.slice(at, found.index) });
    const [whole, equation, code, strong, emphasis, name, to] = found;
    if (equation !== undefined) spans.push({ kind: 'equation', text: equation });
    else if (code !== undefined) spans.push({ kind: 'code', text: code });
    else if (strong !== undefined) spans.push({ kind: 'strong', text: strong });
    else if (emphasis !== undefined) spans.push({ kind: 'emphasis', text: emphasis });
    else spans.push({ kind: 'link', text: name!, to: to! });
    at = found.index + whole.length;
  }
  if (at < text.length) spans.push({ kind: 'text', text: text.slice(at) });
  return spans;
}
