// The parts of a view covered by controls, legends and the status line.

import type { Box } from '../geometry/framing';

const parts = '.view-bar, .legends > *, .status-line, .compass';
const margin = 6; // pixels kept free around them

/// The covered boxes in pixels of the view.
export function boxesOver(host: HTMLElement): Box[] {
  const from = host.getBoundingClientRect();
  return [...host.querySelectorAll(parts)].flatMap((part): Box[] => {
    const { left, top, right, bottom, width } = part.getBoundingClientRect();
    if (width === 0) return [];
    return [
      {
        left: Math.floor(left - from.left - margin),
        top: Math.floor(top - from.top - margin),
        right: Math.ceil(right - from.left + margin),
        bottom: Math.ceil(bottom - from.top + margin),
      },
    ];
  });
}

/// Calls `changed` with the covered boxes, now and whenever they change. Returns a function that ends this.
export function watchOver(host: HTMLElement, changed: (over: Box[]) => void): () => void {
  let last = '';
  let waiting = 0;
  const look = () => {
    waiting = 0;
    const over = boxesOver(host);
    const text = JSON.stringify(over);
    if (text === last) return;
    last = text;
    changed(over);
  };
  const soon = () => (waiting ||= requestAnimationFrame(look));
  const sizes = new ResizeObserver(soon);
  const children = new MutationObserver(() => {
    for (const part of host.querySelectorAll(parts)) sizes.observe(part);
    soon();
  });
  sizes.observe(host);
  for (const part of host.querySelectorAll(parts)) sizes.observe(part);
  children.observe(host, { childList: true, subtree: true });
  look();
  return () => {
    cancelAnimationFrame(waiting);
    sizes.disconnect();
    children.disconnect();
  };
}
