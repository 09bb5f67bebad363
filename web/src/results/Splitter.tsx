import { resultsShare, setResultsShare } from '../state/panels';

const [least, most, step] = [0.2, 0.75, 0.03];
const set = (share: number) => setResultsShare(Math.min(Math.max(share, least), most));

/// The upper edge of the results, moved by dragging or by arrow keys.
export function Splitter() {
  return (
    <div
      class="splitter"
      role="separator"
      aria-orientation="horizontal"
      aria-label="Height of the results"
      aria-valuemin={least * 100}
      aria-valuemax={most * 100}
      aria-valuenow={Math.round(resultsShare.value * 100)}
      tabIndex={0}
      onPointerDown={(event) => {
        event.preventDefault();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) set(1 - event.clientY / innerHeight);
      }}
      onKeyDown={(event) => {
        const way = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
        if (way === 0) return;
        event.preventDefault();
        set(resultsShare.value + way * step);
      }}
    />
  );
}
