import { pathsOverMap } from './over';

/// Whether paths and end points are drawn over the map on the terrain.
export function OverMap() {
  return (
    <label class="choice">
      <input type="checkbox" checked={pathsOverMap.value} onChange={(event) => (pathsOverMap.value = event.currentTarget.checked)} />
      Paths over the map
    </label>
  );
}
