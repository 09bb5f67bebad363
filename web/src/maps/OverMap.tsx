import { pathsOverMap } from './over';

/// The choice whether trajectories and end points are drawn over the map.
export function OverMap() {
  return (
    <label class="choice">
      <input type="checkbox" checked={pathsOverMap.value} onChange={(event) => (pathsOverMap.value = event.currentTarget.checked)} />
      Trajectories over the map
    </label>
  );
}
