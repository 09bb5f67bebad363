// Shows the documentation of Talus in the page.

import type { ComponentChildren, RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { signal } from '@preact/signals';
import { reportFailure } from '../state/messages';
import { owned } from '../state/owned';
import { Dialog } from '../ui/Dialog';
import { textOf } from './documents';
import { blocksOf, sectionOf, spansOf, type Block } from './markdown';
import type { Topic } from '../settings/schema';
import './help.css';

/// The topic that is open; null: none.
export const [reading, read] = owned(signal<Topic | null>(null));

export function DocumentDialog() {
  const topic = reading.value;
  const [blocks, setBlocks] = useState<Block[]>([]);
  const [isWhole, setWhole] = useState(false);
  useEffect(() => {
    setWhole(false);
    setBlocks([]);
    if (topic) void textOf(topic.document).then((text) => setBlocks(blocksOf(text)), reportFailure);
  }, [topic]);
  if (!topic) return null;
  const shown = isWhole ? blocks : sectionOf(blocks, topic.heading);
  return (
    <Dialog title={topic.heading.replaceAll('`', '')} close={() => read(null)}>
      <div class="document">
        {shown.slice(isWhole ? 0 : 1).map((block, k) => (
          <BlockView key={k} block={block} />
        ))}
      </div>
      {!isWhole && shown.length < blocks.length && (
        <button class="button" onClick={() => setWhole(true)}>
          Show the whole document
        </button>
      )}
    </Dialog>
  );
}

/// An equation of the documentation, set once the library for it is loaded.
function Equation({ text, isBlock }: { text: string; isBlock: boolean }) {
  const place = useRef<HTMLElement>(null);
  useEffect(() => {
    void import('./equation').then(({ drawEquation }) => place.current && drawEquation(place.current, text, isBlock), reportFailure);
  }, [text, isBlock]);
  return isBlock ? <div ref={place as RefObject<HTMLDivElement>} class="scroll" /> : <span ref={place} />;
}

function Spans({ text }: { text: string }) {
  return (
    <>
      {spansOf(text).map((span, k): ComponentChildren => {
        switch (span.kind) {
          case 'code':
            return <code key={k}>{span.text}</code>;
          case 'strong':
            return <strong key={k}>{span.text}</strong>;
          case 'emphasis':
            return <em key={k}>{span.text}</em>;
          case 'equation':
            return <Equation key={k} text={span.text} isBlock={false} />;
          case 'link':
            return <span key={k}>{span.text}</span>;
          default:
            return span.text;
        }
      })}
    </>
  );
}

function BlockView({ block }: { block: Block }) {
  switch (block.kind) {
    case 'heading':
      return (
        <h3>
          <Spans text={block.text} />
        </h3>
      );
    case 'paragraph':
      return (
        <p>
          <Spans text={block.text} />
        </p>
      );
    case 'code':
      return <pre>{block.text}</pre>;
    case 'equation':
      return <Equation text={block.text} isBlock />;
    case 'list': {
      const items = block.items.map((item, k) => (
        <li key={k}>
          <Spans text={item} />
        </li>
      ));
      return block.ordered ? <ol>{items}</ol> : <ul>{items}</ul>;
    }
    case 'table':
      return (
        <div class="scroll">
          <table>
            <thead>
              <tr>
                {block.head.map((cell, k) => (
                  <th key={k} scope="col">
                    <Spans text={cell} />
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {block.rows.map((row, k) => (
                <tr key={k}>
                  {row.map((cell, j) => (
                    <td key={j}>
                      <Spans text={cell} />
                    </td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      );
  }
}
