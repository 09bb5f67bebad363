// Shown instead of a missing response: that it is loading, or the error.

import type { Remote } from './remote';

export function Waiting({ of }: { of: Remote<unknown> }) {
  if (of.error !== null)
    return (
      <div class="answer-missing" role="alert">
        <span class="problem">{of.error}</span>
        <button class="button" onClick={of.again}>
          Try again
        </button>
      </div>
    );
  return <div class="empty">{of.isSlow && 'Loading…'}</div>;
}
