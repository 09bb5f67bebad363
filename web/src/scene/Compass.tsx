import type { OpenScene } from './open';
import { sceneCamera } from '../view/sceneCamera';

/// The north arrow; a click shows the plan view.
export function Compass({ open }: { open: OpenScene }) {
  return (
    <button class="compass" title="North arrow. Click for the plan view" aria-label="North arrow: plan view" onClick={() => open.scene.view('plan')}>
      <svg viewBox="-22 -22 44 44" width="44" height="44" aria-hidden="true" style={{ rotate: `${-sceneCamera.value.heading}deg` }}>
        <path class="needle" d="M0 -17 L6 4 L0 1 L-6 4 Z" />
        <text y="17" text-anchor="middle">N</text>
      </svg>
    </button>
  );
}
