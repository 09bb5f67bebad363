import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';

/// The toolbar of a view; in a narrow view it is folded behind its first button.
export function ViewBar({ children }: { children: ComponentChildren }) {
  const [isFolded, fold] = useState(true);
  // A chosen tool, whose card may make the picture narrower still, needs the room; popovers stay.
  const foldAfter = ({ target }: Event) => {
    const button = (target as Element).closest('button');
    if (button && !button.matches('.fold, .icon, .popover *')) fold(true);
  };
  return (
    <div class={`view-bar ${isFolded ? 'folded' : ''}`} role="toolbar" aria-label="View" onClick={foldAfter}>
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
