// The context menu of the views.

import { useLayoutEffect, useRef } from 'preact/hooks';
import { menu, setMenu } from './menu';
import './menu.css';

export function ContextMenu() {
  const element = useRef<HTMLDivElement>(null);
  const now = menu.value;
  useLayoutEffect(() => {
    const list = element.current;
    if (!now || !list) return;
    const before = document.activeElement as HTMLElement | null;
    const { width, height } = list.getBoundingClientRect();
    list.style.left = `${Math.max(4, Math.min(now.x, innerWidth - width - 4))}px`;
    list.style.top = `${Math.max(4, Math.min(now.y, innerHeight - height - 4))}px`;
    list.querySelector('button')?.focus();
    const close = (event: Event) => {
      if (event.type === 'pointerdown' && list.contains(event.target as Node)) return;
      setMenu(null);
    };
    addEventListener('pointerdown', close, true);
    addEventListener('resize', close);
    addEventListener('wheel', close, true);
    return () => {
      removeEventListener('pointerdown', close, true);
      removeEventListener('resize', close);
      removeEventListener('wheel', close, true);
      if (list.contains(document.activeElement) || document.activeElement === document.body) before?.focus({ preventScroll: true });
    };
  }, [now]);
  if (!now) return null;
  const key = (event: KeyboardEvent) => {
    const buttons = [...element.current!.querySelectorAll('button')];
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    if (to !== undefined) buttons.at(to % buttons.length)?.focus();
    else if (event.key === 'Escape' || event.key === 'Tab') setMenu(null);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div ref={element} class="context-menu" role="menu" aria-label={now.title} onKeyDown={key} onContextMenu={(event) => event.preventDefault()}>
      <p class="faint" aria-hidden="true">
        {now.title}
      </p>
      {now.items.map(({ title, act, isDanger }) => (
        <button
          key={title}
          role="menuitem"
          class={`button plain ${isDanger ? 'danger' : ''}`}
          onClick={() => {
            setMenu(null);
            act();
          }}
        >
          {title}
        </button>
      ))}
    </div>
  );
}
