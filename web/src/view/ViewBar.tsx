import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';

/// The toolbar of a view; in a narrow view it is folded behind its first button.
export function ViewBar({ children }: { children: ComponentChildren }) {
  const [isFolded, fold] = useState(true);
  return (
    <div class={`view-bar ${isFolded ? 'folded' : ''}`} role="toolbar" aria-label="View">
      <button
        class="button icon fold"
        title="View tools"
        aria-label="View tools"
        aria-expanded={!isFolded}
        onClick={() => fold(!isFolded)}
      >
        ☰
      </button>
      {children}
    </div>
  );
}
