import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';

/// The row of controls above a picture; where there is little room it is folded behind its first button.
export function ViewBar({ children }: { children: ComponentChildren }) {
  const [isFolded, fold] = useState(true);
  return (
    <div class={`view-bar ${isFolded ? 'folded' : ''}`} role="toolbar" aria-label="View">
      <button
        class="button icon fold"
        title="Tools of the view"
        aria-label="Tools of the view"
        aria-expanded={!isFolded}
        onClick={() => fold(!isFolded)}
      >
        ☰
      </button>
      {children}
    </div>
  );
}
