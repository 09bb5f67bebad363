// The memory that a view takes, below the choices of a popover.

import { useEffect, useRef, useState } from 'preact/hooks';
import { bytesText } from '../units/texts';

/// Of the browser's own count; undefined where it has none.
const heapBytes = () => (performance as { memory?: { usedJSHeapSize: number } }).memory?.usedJSHeapSize;

function memoryText(parts: Record<string, number>): string {
  const drawn = Object.entries(parts).flatMap(([name, bytes]) => (bytes > 0 ? [`${name.toLowerCase()} ${bytesText(bytes)}`] : []));
  const heap = heapBytes();
  return [...drawn, ...(heap === undefined ? [] : [`the page in all about ${bytesText(heap)}`])].join(', ');
}

export function MemoryNote({ parts }: { parts: () => Record<string, number> }) {
  const element = useRef<HTMLParagraphElement>(null);
  const [text, setText] = useState('');
  useEffect(() => {
    const popover = element.current!.closest('details');
    const tell = () => popover?.open && setText(memoryText(parts()));
    popover?.addEventListener('toggle', tell);
    const timer = setInterval(tell, 1000);
    return () => {
      popover?.removeEventListener('toggle', tell);
      clearInterval(timer);
    };
  }, [parts]);
  return (
    <p class="faint memory-note" ref={element}>
      {text !== '' && `Memory: ${text}`}
    </p>
  );
}
