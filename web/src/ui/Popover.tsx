import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import './popover.css';

const margin = 8; // px

/// Moves the panel inside the picture, which would clip it.
function keepInside(content: HTMLElement) {
  const room = (content.closest('.picture') ?? document.documentElement).getBoundingClientRect();
  content.style.left = '0';
  content.style.maxWidth = `${room.width - 2 * margin}px`;
  const { left, right, top } = content.getBoundingClientRect();
  const shift = Math.max(Math.min(0, room.right - margin - right), room.left + margin - left);
  content.style.left = `${shift}px`;
  content.style.maxHeight = `${Math.max(120, room.bottom - margin - top)}px`;
}

/// A button with a panel below it, which closes on Escape or a click outside.
export function Popover({ title, label, children }: { title: ComponentChildren; label?: string; children: ComponentChildren }) {
  const element = useRef<HTMLDetailsElement>(null);
  const content = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const close = (event: Event) => {
      const details = element.current;
      if (!details?.open) return;
      if (event instanceof KeyboardEvent) {
        if (event.key !== 'Escape') return;
        details.open = false;
        details.querySelector('summary')?.focus();
        event.stopPropagation();
      } else if (!details.contains(event.target as Node)) details.open = false;
    };
    const place = () => element.current?.open && content.current && keepInside(content.current);
    addEventListener('pointerdown', close, true);
    addEventListener('keydown', close, true);
    addEventListener('resize', place);
    return () => {
      removeEventListener('resize', place);
      removeEventListener('pointerdown', close, true);
      removeEventListener('keydown', close, true);
    };
  }, []);
  return (
    <details
      class="popover"
      ref={element}
      onToggle={(event) => event.currentTarget.open && content.current && keepInside(content.current)}
    >
      <summary class="button" aria-label={label}>
        {title} <span aria-hidden="true">▾</span>
      </summary>
      <div class="content" ref={content}>
        {children}
      </div>
    </details>
  );
}
