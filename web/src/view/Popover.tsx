import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import './popover.css';

/// A button with a small panel below it, which closes by Escape or a press outside.
export function Popover({ title, label, children }: { title: ComponentChildren; label?: string; children: ComponentChildren }) {
  const element = useRef<HTMLDetailsElement>(null);
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
    addEventListener('pointerdown', close, true);
    addEventListener('keydown', close, true);
    return () => {
      removeEventListener('pointerdown', close, true);
      removeEventListener('keydown', close, true);
    };
  }, []);
  return (
    <details class="popover" ref={element}>
      <summary class="button" aria-label={label}>
        {title} <span aria-hidden="true">▾</span>
      </summary>
      <div class="content">{children}</div>
    </details>
  );
}
