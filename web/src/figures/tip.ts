// The tooltip of figures.

import { select, type BaseType, type Selection } from 'd3-selection';

let box: HTMLElement | null = null;

function tipBox(): HTMLElement {
  if (!box?.isConnected) {
    const made = select(document.body).append('div').attr('id', 'tip').attr('role', 'status');
    box = made.node()!;
  }
  return box;
}

export function hideTip() {
  if (box) box.hidden = true;
}

/// Shows the text next to a position of the window, within its edges.
export function showTip(text: string, x: number, y: number) {
  const node = tipBox();
  node.hidden = false;
  node.textContent = text;
  const { width, height } = node.getBoundingClientRect();
  const left = x + 14 + width > innerWidth ? x - 14 - width : x + 14;
  const top = y + 16 + height > innerHeight ? y - 12 - height : y + 16;
  node.style.left = `${Math.max(0, left)}px`;
  node.style.top = `${Math.max(0, top)}px`;
}

/// Adds a tooltip to each element; `textOf` returns its text.
export function tip<Node extends BaseType, Datum>(
  selection: Selection<Node, Datum, BaseType, unknown>,
  textOf: (datum: Datum, event: MouseEvent) => string,
) {
  selection.each(function (datum) {
    const node = this as unknown as SVGElement;
    node.addEventListener('mousemove', (event) => showTip(textOf(datum, event), event.clientX, event.clientY));
    node.addEventListener('mouseleave', hideTip);
  });
  return selection;
}
